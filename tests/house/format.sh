#!/usr/bin/env bash
# All C++ is as clang-format (.clang-format) would have it:  format.sh SOURCE_DIR
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo 'clang-format is missing: cmake/setup.sh test'; exit 1; }
# Many files a process: starting one takes longer than most files.
find src tests shaders -type f \( -name '*.h' -o -name '*.cpp' \) -print0 | sort -z |
  xargs -0 -n 100 clang-format --dry-run -Werror
