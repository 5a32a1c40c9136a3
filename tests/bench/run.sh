#!/usr/bin/env bash
# Builds the benchmarks in build-bench/ and runs them:
#   tests/bench/run.sh [vkpt-bench's arguments]                     vkpt against Embree
#   tests/bench/run.sh --effects [vkpt-bench-effects's arguments]   kernels without and with what a scene needs not
# With npm and a network a real mesh stands in the box, too, against Embree. Both programs have --help.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
source "$root/cmake/build.sh"
program=vkpt-bench
if [[ ${1-} == --effects ]]; then
  program=vkpt-bench-effects
  shift
fi
lockBuild
"$root/cmake/setup.sh" bench
configure build-bench bench -DVKPT_BENCHMARKS=ON
build build-bench "$program"
arguments=()
if [[ $program == vkpt-bench ]]; then
  if mesh=$("$root/tests/bench/fetch_meshes.sh" "$root/build-bench/meshes"); then
    arguments=(--mesh "$mesh")
  else
    echo 'run: going on without a mesh' >&2
  fi
fi
unlockBuild
exec "$root/build-bench/$program" "${arguments[@]}" "$@"
