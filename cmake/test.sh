#!/usr/bin/env bash
# Sets up, builds and runs the tests:  cmake/test.sh [--long] [ctest's arguments]
# --long adds the tests labelled `long`. Three trees, one ctest run: build/ has all tests, build-san/ has the host-side
# ones under AddressSanitizer and UndefinedBehaviorSanitizer (names start with `sanitized.`), build-fuzz/ the fuzzers.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
source "$root/cmake/build.sh"

filter=(-LE '^long$')
arguments=()
for argument in "$@"; do
  case $argument in
  --long) filter=() ;;
  -h | --help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" && exit 0 ;;
  *) arguments+=("$argument") ;;
  esac
done

lockBuild
"$root/cmake/setup.sh" test
configure build default -DVKPT_TESTS=ON
build build all
configure build-san sanitize -DVKPT_TESTS=ON
build build-san vkpt_tests
configure build-fuzz fuzz -DVKPT_FUZZ=ON
build build-fuzz vkpt_fuzzers
unlockBuild

joined=$root/build/joined # a ctest folder that joins the trees, so that there is one summary
mkdir -p "$joined"
printf 'subdirs("%s" "%s" "%s")\n' "$root/build" "$root/build-san" "$root/build-fuzz" >"$joined/CTestTestfile.cmake"
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_stack_use_after_return=1:strict_string_checks=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
exec ctest --test-dir "$joined" --output-on-failure --no-tests=error -j2 "${filter[@]}" "${arguments[@]}"
