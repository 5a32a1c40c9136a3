#!/usr/bin/env bash
# Every row of the hard cases names a case or a test that exists:  rows.sh ROWS.txt VKPT BUILD_DIR
set -euo pipefail
rows=$1 vkpt=$2 build=$3
cases=$("$vkpt" selftest --list | awk '{print $1}')
tests=$(ctest --test-dir "$build" -N | sed -n 's/^ *Test *#[0-9]*: //p')
bad=0
while read -r row kind name; do
  case $kind in
  case) grep -qxF -- "$name" <<<"$cases" || { echo "$row: no case $name"; bad=1; } ;;
  test)
    found=
    while read -r test; do
      # shellcheck disable=SC2053 # a pattern
      [[ $test == $name ]] && found=1 && break
    done <<<"$tests"
    [[ $found ]] || { echo "$row: no test $name"; bad=1; } ;;
  *) echo "$row: neither case nor test: $kind"; bad=1 ;;
  esac
done < <(sed 's/#.*//; /^ *$/d' "$rows")
for row in W{1..13} O{1..10} D{1..14} M{1..15} I{1..8}; do
  grep -q "^$row " "$rows" || { echo "$row: no row"; bad=1; }
done
exit $bad
