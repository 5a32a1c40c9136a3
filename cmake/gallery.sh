#!/usr/bin/env bash
# Renders every picture of the two assignments, one command a task:  cmake/gallery.sh [-q SCALE] [-o DIR] [TASK...]
# SCALE multiplies the samples (default 1; 0.05 is a look, 16 is for print). Without TASK all of them, in order;
# `cmake/gallery.sh --list` names them. What each run said is in DIR/NAME.txt beside DIR/NAME.png.
set -euo pipefail
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")

# The one list: name, samples a pixel, vkpt's arguments.
tasks='
a-blocks              512  cornell --roulette albedo --light nee
a-spheres            1024  cornell-spheres --roulette albedo --light nee
a-primary-caustics   1024  cornell-spheres --paths caustic --light nee
a-secondary-caustics 1024  cornell-spheres --paths indirect-caustic --light nee --exposure 2
a-roulette            256  cornell-spheres --roulette albedo --light nee --split 0
a-split-1             256  cornell-spheres --roulette albedo --light nee --split 1
a-split-2             256  cornell-spheres --roulette albedo --light nee --split 2
a-split-4             256  cornell-spheres --roulette albedo --light nee --split 4
b-busts                64  assets/busts.xml --light nee --max-bounces 2
b-cbox-q1.0           256  assets/cbox.xml --light nee --roulette constant=1.0 --exposure 1
b-cbox-q0.7           256  assets/cbox.xml --light nee --roulette constant=0.7 --exposure 1
b-cbox-q0.4           256  assets/cbox.xml --light nee --roulette constant=0.4 --exposure 1
b-cbox-q0.1           256  assets/cbox.xml --light nee --roulette constant=0.1 --exposure 1
b-own-q1.0            256  assets/q-scene.xml --light nee --roulette constant=1.0
b-own-q0.7            256  assets/q-scene.xml --light nee --roulette constant=0.7
b-own-q0.4            256  assets/q-scene.xml --light nee --roulette constant=0.4
b-own-q0.1            256  assets/q-scene.xml --light nee --roulette constant=0.1
b-own-time-q1.0      time  assets/q-scene.xml --light nee --roulette constant=1.0
b-own-time-q0.7      time  assets/q-scene.xml --light nee --roulette constant=0.7
b-own-time-q0.4      time  assets/q-scene.xml --light nee --roulette constant=0.4
b-own-time-q0.1      time  assets/q-scene.xml --light nee --roulette constant=0.1
b-meshes              256  assets/cbox-meshes.xml --light nee --roulette constant=0.1
b-meshes-mis          256  assets/cbox-meshes.xml --light mis
'
secondsOfEqualTime=20

fail() {
  echo "gallery: $*" >&2
  exit 1
}

scale=1 folder=gallery wanted=()
while [[ $# -gt 0 ]]; do
  case $1 in
  -q) scale=${2:?gallery: -q takes a number} && shift 2 ;;
  -o) folder=${2:?gallery: -o takes a folder} && shift 2 ;;
  --list) awk 'NF { print $1 }' <<<"$tasks" && exit ;;
  -h | --help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" && exit ;;
  -*) fail "unknown option $1: -q SCALE, -o DIR, --list" ;;
  *) wanted+=("$1") && shift ;;
  esac
done
[[ $scale =~ ^[0-9]*\.?[0-9]+$ ]] || fail "-q $scale: a number above 0, e.g. 0.1"
for name in "${wanted[@]}"; do
  awk -v n="$name" '$1 == n { found = 1 } END { exit !found }' <<<"$tasks" || fail "no task '$name'; see --list"
done

mkdir -p "$folder"
folder=$(readlink -f "$folder")
"$root/cmake/run.sh" --version >&2 # sets up and builds
cd "$root"
while read -r name samples arguments; do
  [[ -n $name ]] || continue
  [[ ${#wanted[@]} -eq 0 || " ${wanted[*]} " == *" $name "* ]] || continue
  read -r -a words <<<"$arguments"
  if [[ $samples == time ]]; then
    words+=(--time "$(awk -v s="$scale" -v t="$secondsOfEqualTime" 'BEGIN { print s * t }')")
  else
    words+=(--frames "$(awk -v s="$scale" -v n="$samples" 'BEGIN { n = int(s * n + 0.5); print n < 2 ? 2 : n }')")
  fi
  [[ -z ${VKPT_GALLERY_SIZE-} ]] || words+=(--size "$VKPT_GALLERY_SIZE")
  echo "$name: vkpt ${words[*]}"
  build/vkpt "${words[@]}" --no-progress -o "$folder/$name.png" >"$folder/$name.txt"
  sed -n 's/^.* samples per pixel in/  &/p; s/^mean radiance/  &/p' "$folder/$name.txt"
done <<<"$tasks"
