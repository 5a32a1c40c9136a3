#!/usr/bin/env bash
# Every source compiles by itself, too: with all that it includes, and no more.  separate.sh SOURCE_DIR [BASE]
# Parses each as the build would without CMAKE_UNITY_BUILD; with BASE those alone that have changed since that commit.
set -euo pipefail
source_dir=$1 base=${2-}
world=$(mktemp -d)
trap 'rm -rf "$world"' EXIT
cmake -S "$source_dir" -B "$world" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVKPT_TESTS=ON -DCMAKE_UNITY_BUILD=OFF \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
cd "$source_dir"
python3 - "$world/compile_commands.json" <<'PYTHON' >"$world/all"
import json, sys
for entry in json.load(open(sys.argv[1])):
    print(entry['file'], entry['command'].replace(' -o ', ' -fsyntax-only -o ', 1), sep='\t')
PYTHON
awk -F '\t' -v ours="$source_dir/" 'index($1, ours) == 1' "$world/all" | sort -u -t $'\t' -k 1,1 >"$world/ours" # what
# the build makes is not there yet
if [[ $base ]]; then
  git diff --name-only "$base" | sed "s|^|$source_dir/|" >"$world/changed"
  grep -Ff "$world/changed" "$world/ours" >"$world/some" && mv "$world/some" "$world/ours"
fi
echo "$(wc -l <"$world/ours") sources"
cut -f 2 "$world/ours" | xargs -d '\n' -P 2 -I {} sh -c '{}'
