#!/usr/bin/env bash
# The benchmarks build, and vkpt and the yardstick compute the same on small images:  bench.sh SOURCE_DIR
set -euo pipefail
root=$1
small=(--rounds 1 --size 64)
"$root/tests/bench/run.sh" --scenes blocks,spheres,busts,lights "${small[@]}" --frames 4
"$root/tests/bench/run.sh" --effects --scenes cornell "${small[@]}" --frames 1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$root/tests/bench/run.sh" --errors --scenes blocks "${small[@]}" --seconds 0.1 --reference-seconds 0.1 --folder "$folder"
