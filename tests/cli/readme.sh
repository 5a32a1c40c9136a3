#!/usr/bin/env bash
# The README is true: its tables name every option and every MTL key, its links lead somewhere, and every line of its
# fenced `sh` blocks runs, in an empty folder with the house's parts beside it, at a small image size:
#   readme.sh SOURCE_DIR VKPT
# cmake/test.sh is not run (it runs this), only looked for. cmake/run.sh is run where it would start the VKPT under
# test; else a stand-in starts that one.
set -euo pipefail
source_dir=$1 vkpt=$2
size=${VKPT_README_SIZE:-48x48}
readme=$source_dir/README.md
lab=$(mktemp -d)
trap 'rm -rf "$lab"' EXIT
cd "$lab"

# firstCells PATTERN: what matches it in the first cells of the README's tables, sorted.
firstCells() { sed -n -E 's/^\| ([^|]*(\\\|[^|]*)*) \|.*/\1/p' "$readme" | grep -oE -- "$1" | sort -u; }
same() {
  diff "$2" "$3" >difference || { echo "README.md and $1 differ (<: only the README):"; grep '^[<>]' difference; exit 1; }
}
firstCells '`(-o`, `)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u >written
"$vkpt" --help | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u >there
same 'vkpt --help' written there
mtl=$source_dir/src/scene/mtl_table.h
grep -oE 'MtlKey\{"[^"]+"' "$mtl" | cut -d'"' -f2 | sort -u >there
sed -n '/^### MTL/,/^## /p' "$readme" | grep '^| `' | cut -d'|' -f2 | grep -oE '`[^`]+`' | tr -d '`' | sort -u >written
same src/scene/mtl_table.h written there
while IFS= read -r link; do
  [[ -e $source_dir/$link ]] || { echo "README.md: there is no $link"; exit 1; }
done < <(grep -oE '\]\([^)#:]+\)' "$readme" | tr -d ']()')

ln -s "$source_dir/assets" assets
ln -s "$(dirname "$vkpt")" build
if [[ $(readlink -f "$vkpt") == $(readlink -f "$source_dir/build/vkpt") ]]; then
  ln -s "$source_dir/cmake" cmake
else
  mkdir cmake
  printf '#!/usr/bin/env bash\nexec "%s" "$@"\n' "$vkpt" >cmake/run.sh
  chmod +x cmake/run.sh
fi

count=0
while IFS= read -r line; do
  line=${line%%#*}
  [[ -n ${line// /} ]] || continue
  count=$((count + 1))
  read -r -a words <<<"$line"
  case ${words[0]} in
  cmake/test.sh)
    [[ -x $source_dir/cmake/test.sh ]] || { echo "there is no $line"; exit 1; }
    continue
    ;;
  cmake/run.sh | build/vkpt) [[ $line == *--size* || ${words[1]-} == assignment ]] || words+=(--size "$size") ;;
  esac
  # The preview gets a screen, and closes by itself.
  [[ ${words[1]-} != view ]] || words=(xvfb-run -a "${words[@]}" --frames 1 --close)
  echo "\$ ${words[*]}"
  "${words[@]}" || { echo "README.md: failed: $line"; exit 1; }
  for ((i = 1; i < ${#words[@]} - 1; ++i)); do
    case ${words[i]} in
    -o | --output | --stats) [[ -s ${words[i + 1]} ]] || { echo "README.md: no ${words[i + 1]} from: $line"; exit 1; } ;;
    esac
  done
done < <(awk '/^```/ { inside = !inside && $0 == "```sh"; next } inside' "$readme")
[[ $count -ge 5 ]] || { echo "README.md: only $count commands found"; exit 1; }
[[ -s vkpt.png ]] || { echo 'README.md: no command left vkpt.png'; exit 1; }
