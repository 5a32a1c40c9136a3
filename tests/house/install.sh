#!/usr/bin/env bash
# What `cmake --install` makes can be moved, and serves a program elsewhere:  install.sh SOURCE_DIR BUILD_DIR COMPILER
set -euo pipefail
source_dir=$1 build_dir=$2 compiler=$3
lab=$(mktemp -d)
trap 'rm -rf "$lab"' EXIT
cmake --install "$build_dir" --prefix "$lab/first" >/dev/null
mv "$lab/first" "$lab/prefix"

foreign=()
for folder in "$source_dir" "$build_dir" "$lab/first"; do
  foreign+=(-e "\"$folder" -e ";$folder" -e ":$folder")
done
if grep -rnF "${foreign[@]}" "$lab/prefix"/lib*/cmake; then
  echo 'the package names folders of the machine it was built on'
  exit 1
fi
[[ -s $lab/prefix/share/doc/vkpt/LICENSE ]] || { echo 'no licence was installed'; exit 1; }
if [[ -x $build_dir/vkpt ]]; then
  (cd "$lab" && prefix/bin/vkpt --list-scenes >/dev/null)
fi

cp -r "$source_dir/tests/house/consumer" "$lab/consumer"
cmake -G Ninja -S "$lab/consumer" -B "$lab/build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$lab/prefix" >/dev/null
cmake --build "$lab/build" >"$lab/log" 2>&1 || { cat "$lab/log"; exit 1; }
"$lab/build/consumer"
