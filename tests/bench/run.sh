#!/usr/bin/env bash
# Builds the benchmarks in build-bench/ and runs them:  tests/bench/run.sh [vkpt-bench's arguments]
# With npm and a network a real mesh stands in the box, too. See vkpt-bench --help.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
source "$root/cmake/build.sh"
lockBuild
"$root/cmake/setup.sh" bench
configure build-bench bench -DVKPT_BENCHMARKS=ON
build build-bench vkpt-bench
arguments=()
if mesh=$("$root/tests/bench/fetch_meshes.sh" "$root/build-bench/meshes"); then
  arguments=(--mesh "$mesh")
else
  echo 'run: going on without a mesh' >&2
fi
unlockBuild
exec "$root/build-bench/vkpt-bench" "${arguments[@]}" "$@"
