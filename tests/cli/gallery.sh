#!/usr/bin/env bash
# cmake/gallery.sh renders every task of the assignments, tiny here; the README's table has the same ones, with the same
# commands:  gallery.sh SOURCE_DIR
set -euo pipefail
source_dir=$1
if [[ ! -d $source_dir/build ]]; then
  echo 'no build folder of the default preset here: not run'
  exit 0
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$source_dir/cmake/gallery.sh" --list >"$folder/tasks"
VKPT_GALLERY_SIZE=32x32 "$source_dir/cmake/gallery.sh" -q 0.01 -o "$folder/out" >"$folder/said"
while read -r name; do
  [[ -s $folder/out/$name.png && -s $folder/out/$name.txt ]] || { echo "gallery: no picture of $name"; exit 1; }
  grep -q "\`$name\`" "$source_dir/README.md" || { echo "README.md: no line about $name"; exit 1; }
done <"$folder/tasks"
if "$source_dir/cmake/gallery.sh" -o "$folder/out" a-nothing 2>"$folder/error"; then
  echo 'gallery: a task that is not there is not refused'
  exit 1
fi
grep -q "no task 'a-nothing'" "$folder/error"
