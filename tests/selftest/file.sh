#!/usr/bin/env bash
# A file of tests passes, and where it has references does not once the first of them is 4 % off:
#   file.sh VKPT ASSETS NAME
set -euo pipefail
vkpt=$1 assets=$2 name=$3
lab=$(mktemp -d)
trap 'rm -rf "$lab"' EXIT
fail() {
  echo "$*"
  cat "$lab/out" "$lab/err"
  exit 1
}
# run FILE: sets `code`, fills out and err.
run() {
  code=0
  "$vkpt" selftest "$1" --validation >"$lab/out" 2>"$lab/err" || code=$?
}

run "$assets/tests/$name.xml"
[[ $code -eq 0 && ! -s $lab/err ]] || fail "exit code $code"
! grep -qE '^FAIL' "$lab/out" || fail 'a line says FAIL'
grep -qE '^[0-9]+ passed, 0 failed \(seed 0\)$' "$lab/out" || fail 'no summary'

grep -q '"references"' "$assets/tests/$name.xml" || exit 0
mkdir "$lab/tests"
ln -s "$assets/meshes" "$lab/meshes"
awk '!done && match($0, /"references" value="[0-9.]+/) {
       text = substr($0, RSTART, RLENGTH)
       number = substr(text, length("\"references\" value=\"") + 1)
       sub(text, "\"references\" value=\"" number * 1.04)
       done = 1
     }
     { print }' "$assets/tests/$name.xml" >"$lab/tests/wrong.xml"
run "$lab/tests/wrong.xml"
[[ $code -eq 4 ]] || fail "exit code $code for a wrong reference"
[[ $(grep -cE '^FAIL' "$lab/out") -eq 1 ]] || fail 'not one test failed of a file with one wrong reference'
grep -qE '^vkpt: error: .*wrong.xml: 1 of [0-9]+ tests? failed \(seed 0\)$' "$lab/err" || fail 'no error line'
[[ $(wc -l <"$lab/err") -eq 1 ]] || fail 'more than one line of errors'
