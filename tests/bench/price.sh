#!/usr/bin/env bash
# What stability costs in time, as the table of the README:  tests/bench/price.sh
# One core, medians of 15 renders in turns, time of the processor.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
source "$root/cmake/build.sh"

lockBuild
"$root/cmake/setup.sh" test
configure build default -DVKPT_TESTS=ON
build build stability_price
unlockBuild
exec taskset -c 0 "$root/build/stability_price"
