#!/usr/bin/env bash
# Builds the benchmarks in build-bench/ and runs them:
#   tests/bench/run.sh [vkpt-bench's arguments]                     vkpt against Embree
#   tests/bench/run.sh --scaling [the same]                         one shape in 1 k to 1 M triangles
#   tests/bench/run.sh --effects [vkpt-bench-effects's arguments]   kernels without and with what a scene needs not
#   tests/bench/run.sh --errors [vkpt-bench-errors's arguments]     the error that a second of one core buys
# With npm and a network a real mesh stands in the box, too. All have --help; each ends with a line of JSON, which
# tests/bench/tables.py makes the README's tables and plot from.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
source "$root/cmake/build.sh"
program=vkpt-bench
if [[ ${1-} == --effects || ${1-} == --errors ]]; then
  program=vkpt-bench-${1#--}
  shift
fi
lockBuild
"$root/cmake/setup.sh" bench
configure build-bench bench -DVKPT_BENCHMARKS=ON
build build-bench "$program"
arguments=()
if [[ $program != vkpt-bench-effects ]] && [[ " $*" != *' --sc'* || $* == *mesh* ]]; then # --scenes, --scaling
  if mesh=$("$root/tests/bench/fetch_meshes.sh" "$root/build-bench/meshes"); then
    arguments=(--mesh "$mesh")
  else
    echo 'run: going on without a mesh' >&2
  fi
fi
if [[ $program == vkpt-bench-errors ]]; then
  [[ " $* " == *' --folder '* ]] || arguments+=(--folder "$root/build-bench") # references take minutes: they are kept
fi
unlockBuild
exec "$root/build-bench/$program" "${arguments[@]}" "$@"
