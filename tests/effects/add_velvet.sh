#!/usr/bin/env bash
# Copies the shaders and adds a BSDF by the first steps of the README's list:  add_velvet.sh SHADERS COPY
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
rm -rf "$2"
cp -r "$1" "$2"

# insertBefore FILE START LINE: before the one line that starts so.
insertBefore() {
  start=$2 line=$3 awk '
    index($0, ENVIRON["start"]) == 1 { print ENVIRON["line"]; found += 1 }
    { print }
    END { exit found != 1 }' "$1" >"$1.new" || { echo "add_velvet: $1: not one line '$2'" >&2 && exit 1; }
  mv "$1.new" "$1"
}

# Step 1: two lines in the list of effects.
insertBefore "$2/shared/effects.h" '  X(0, Diffuse, diffuse' '  X(63, Velvet, velvet, "a triangle with velvet") \'
insertBefore "$2/shared/effects.h" '  X(Phong, Phong)' '  X(Velvet, Velvet) \'
# Step 2: a file, and its place in the library.
cp "$here/bsdf_velvet.glsl" "$2/lib"
insertBefore "$2/lib/library.glsl" '#include "texture.glsl"' '#include "bsdf_velvet.glsl"'
