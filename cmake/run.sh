#!/usr/bin/env bash
# Sets up, builds and runs vkpt, from any folder:  cmake/run.sh [vkpt's arguments]
# Without arguments it renders the built-in Cornell box to vkpt.png. stdout carries vkpt's results only.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
source "$root/cmake/build.sh"

lockBuild
"$root/cmake/setup.sh" build
configure build default
build build vkpt
unlockBuild
exec "$root/build/vkpt" "$@"
