#!/usr/bin/env bash
# Shows that each fuzzer finds a bug that is planted in a copy of the sources, from the committed corpus:
#   planted.sh SOURCE_DIR
# Each bug is a check left out, one that a reader once could have lacked.
set -euo pipefail
source_dir=$1
world=$(mktemp -d)
trap 'rm -rf "$world"' EXIT
mkdir "$world/vkpt"
cp -r "$source_dir"/{CMakeLists.txt,CMakePresets.json,LICENSE,assets,cmake,shaders,src,tests} "$world/vkpt"
cd "$world/vkpt"
cmake --preset fuzz >/dev/null

# fuzzer, file, the check, what stands in its place
bugs='
obj    src/scene/obj_reader.cpp      index >= count                       index > count
nori   src/scene/nori_transform.cpp  numbers.size() != 16                 numbers.empty()
image  src/decode/hdr.cpp            count == 0 || count > width - x      count == 0
image  src/decode/jpeg_check.cpp     codes > kMostCodes                   codes > 4 * kMostCodes
image  src/film/exr_check.cpp        value.size() != fixed->bytes         value.empty()
'
while IFS= read -r bug; do
  [[ -n $bug ]] || continue
  IFS=$'\t' read -r fuzzer file check instead < <(sed -E 's/  +/\t/g; s/^([a-z]+) +/\1\t/; s/\t+/\t/g' <<<"$bug")
  cp "$file" "$world/right"
  content=$(<"$file")
  [[ $content == *"$check"* ]] || { echo "$file has no '$check'"; exit 1; }
  printf '%s\n' "${content/"$check"/"$instead"}" >"$file"
  cmake --build build-fuzz --target "fuzz_$fuzzer" >"$world/log" 2>&1 || { cat "$world/log"; exit 1; }
  mkdir -p "$world/run/found"
  if (cd "$world/run" && "$world/vkpt/build-fuzz/fuzz_$fuzzer" -max_total_time=300 -max_len=4096 -rss_limit_mb=2048 \
    -verbosity=0 -dict="$world/vkpt/tests/fuzz/$fuzzer.dict" found "$world/vkpt/tests/fuzz/corpus/$fuzzer") >"$world/log" 2>&1; then
    echo "the fuzzer $fuzzer did not notice: $file without '$check'"
    exit 1
  fi
  echo "$fuzzer: '$check' of $file: $(grep -m1 -oE 'SUMMARY: .*|memory: .*' "$world/log")"
  rm -r "$world/run"
  mv "$world/right" "$file"
  touch "$file"
done <<<"$bugs"
