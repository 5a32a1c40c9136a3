#!/usr/bin/env bash
# The preview against the headless command at the same size, in turns, on a screen of Xvfb:
#   tests/bench/view.sh [-n ROUNDS] [-s SECONDS] [SCENE [vkpt's options]]
# Prints Msamples/s of both, medians of the rounds, and their ratio; and the longest time that input waited.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
rounds=3 seconds=10
while getopts n:s: option; do
  case $option in
  n) rounds=$OPTARG ;;
  s) seconds=$OPTARG ;;
  *) exit 1 ;;
  esac
done
shift $((OPTIND - 1))
scene=("${@:-cornell-spheres}")
lab=$(mktemp -d)
trap 'rm -rf "$lab"' EXIT

rate() { sed -n 's/^ *"samplesPerSecond": \([0-9.e+]*\),*$/\1/p' "$1"; }
median() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
for ((i = 0; i < rounds; ++i)); do
  "$root/build/vkpt" "${scene[@]}" --time "$seconds" --quiet -o "$lab/x.png" --stats "$lab/headless.json"
  rate "$lab/headless.json" >>"$lab/headless"
  xvfb-run -a "$root/build/vkpt" view "${scene[@]}" --time "$seconds" --quiet --close --log-events --stats "$lab/view.json" >"$lab/events"
  rate "$lab/view.json" >>"$lab/view"
  sed -n 's/.*"longestWait":\([0-9.e+-]*\).*/\1/p' "$lab/events" >>"$lab/waits"
  sed -n 's/.*"event":"first picture","seconds":\([0-9.e+-]*\).*/\1/p' "$lab/events" >>"$lab/first"
done
awk -v v="$(median <"$lab/view")" -v h="$(median <"$lab/headless")" -v s="${scene[*]}" -v w="$(median <"$lab/waits")" \
  -v f="$(median <"$lab/first")" 'BEGIN {
    printf "%s: preview %.2f Msamples/s, headless %.2f, ratio %.2f\n", s, v * 1e-6, h * 1e-6, v / h
    printf "first picture after %.2f s; input waited %.0f ms at most\n", f, w * 1000 }'
