#!/usr/bin/env bash
# Fails on an upward include:  layers.sh SOURCE_DIR
# Below is the diagram of the layers: each folder of src/, then the folders it may include. It is closed: what a
# layer reaches through another is listed too. The shaders' headers (shaders/) are open to all, and see no layer.
set -euo pipefail
cd "$1"

diagram='
core
decode  core
gpu     core
scene   core decode
accel   core
film    core decode
device  core decode gpu scene accel
render  core decode gpu scene accel device film
host    core decode scene accel film device
study   core decode gpu scene accel device film render host
selftest core decode gpu scene accel film device render host
app     core decode gpu scene accel device film render host study selftest
'
names=$(awk '{print $1}' <<<"$diagram")
bad=0
report() {
  echo "$*"
  bad=1
}

# includes FOLDER: file:line:name of every include; one in a comment does not count.
includes() {
  find "$1" -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.glsl' -o -name '*.comp' \) -print0 |
    xargs -0r grep -HnoE '^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"][^>"]+' | sed -E 's/:[[:space:]]*#[^<"]*[<"]/:/'
}

# check LAYER MAY...: the includes of src/LAYER, and the libraries its CMakeLists.txt links to.
check() {
  local layer=$1 may=" $* " where name first
  while IFS= read -r line; do
    where=${line%:*} name=${line##*:}
    first=${name%%/*}
    case $name in
    *../*) report "$where: \"$name\" climbs out of its folder; write it from src/ on" ;;
    GLFW/* | imgui*) [[ $where == src/app/view/* ]] || report "$where: only app/view knows $name" ;;
    vulkan/*) [[ $may == *' gpu '* ]] || report "$where: src/$layer may not see Vulkan" ;;
    */*)
      if grep -qxF "$first" <<<"$names" && [[ $may != *" $first "* ]]; then
        report "$where: src/$layer may not include \"$name\", only from:${may% }"
      fi
      ;;
    esac
  done < <(includes "src/$layer")
  [[ -e src/$layer/CMakeLists.txt ]] || return 0
  while IFS= read -r first; do
    if grep -qxF "$first" <<<"$names" && [[ $may != *" $first "* ]]; then
      report "src/$layer/CMakeLists.txt: src/$layer may not link to vkpt::$first, only to:${may% }"
    fi
  done < <(sed 's/#.*//' "src/$layer/CMakeLists.txt" | grep -oE 'vkpt(::|_)[a-z]+' | sed -E 's/vkpt(::|_)//' | sort -u)
}

while read -r -a row; do
  [[ ${#row[@]} -eq 0 || ! -d src/${row[0]} ]] || check "${row[@]}"
done <<<"$diagram"

for folder in src/*/; do
  folder=$(basename "$folder")
  grep -qxF "$folder" <<<"$names" || report "src/$folder: no such layer; give it a row in the diagram of tests/house/layers.sh"
done

while IFS= read -r line; do
  name=${line##*:}
  if grep -qxF "${name%%/*}" <<<"$names" || [[ $name == *../*../* ]]; then
    report "${line%:*}: a shader may not include \"$name\""
  fi
done < <(includes shaders)
exit $bad
