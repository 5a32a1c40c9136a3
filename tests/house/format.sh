#!/usr/bin/env bash
# All C++ is as clang-format (.clang-format) would have it:  format.sh SOURCE_DIR
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo 'clang-format is missing: cmake/setup.sh test'; exit 1; }
bad=0
while IFS= read -r -d '' file; do
  if ! clang-format "$file" | cmp -s - "$file"; then
    echo "$file is not formatted: clang-format -i $file"
    bad=1
  fi
done < <(find src tests shaders -type f \( -name '*.h' -o -name '*.cpp' \) -print0 | sort -z)
exit $bad
