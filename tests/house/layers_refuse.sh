#!/usr/bin/env bash
# layers.sh accepts what the diagram allows and refuses each kind of breach:  layers_refuse.sh SOURCE_DIR
set -euo pipefail
layers=$1/tests/house/layers.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

# A small tree that is right.
plant() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/src/{core,gpu,scene,accel,film,device,render,app/view} "$tree"/shaders/lib
  printf '#include <vector>\n#include "core/hash.h"\n// #include "gpu/x.h"\n' >"$tree/src/core/a.h"
  printf '#include "core/a.h"\n#include "local.h"\n#include "shared/structs.h"\n' >"$tree/src/scene/a.h"
  printf '#include "core/a.h"\n#include <vulkan/vulkan_raii.hpp>\n' >"$tree/src/gpu/a.h"
  printf '#include "device/a.h"\n#include "scene/a.h"\n#include "film/a.h"\n' >"$tree/src/render/a.cpp"
  printf '#include <GLFW/glfw3.h>\n' >"$tree/src/app/view/a.cpp"
  printf 'vkpt_library(device DEPENDS vkpt::scene vkpt::gpu) # not vkpt::render\n' >"$tree/src/device/CMakeLists.txt"
  printf '#include "ray.glsl"\n#include "../shared/structs.h"\n' >"$tree/shaders/lib/a.glsl"
}
plant
bash "$layers" "$tree"

# refuses FILE LINE WHERE: that tree with LINE added to FILE is refused, and the message names WHERE.
refuses() {
  plant
  mkdir -p "$(dirname "$tree/$1")"
  printf '%s\n' "$2" >>"$tree/$1"
  local said
  if said=$(bash "$layers" "$tree") || [[ $said != *"$3"* ]]; then
    echo "not refused: $2 in $1 (said: $said)"
    exit 1
  fi
}
refuses src/core/a.h '#include "scene/scene.h"' src/core/a.h:4
refuses src/core/a.h '  #  include <scene/scene.h>' src/core/a.h:4
refuses src/scene/a.h '#include "accel/bvh.h"' src/scene/a.h:4
refuses src/accel/a.h '#include "gpu/context.h"' src/accel/a.h:1
refuses src/film/a.h '#include "scene/scene.h"' src/film/a.h:1
refuses src/film/a.h '#include <vulkan/vulkan.h>' src/film/a.h:1
refuses src/device/a.h '#include "film/film.h"' src/device/a.h:1
refuses src/device/CMakeLists.txt 'target_link_libraries(vkpt_device PUBLIC vkpt::render)' src/device/CMakeLists.txt
refuses src/render/sub/a.h '#include "app/options.h"' src/render/sub/a.h:1
refuses src/render/a.cpp '#include <GLFW/glfw3.h>' src/render/a.cpp:4
refuses src/gpu/a.h '#include "../scene/scene.h"' src/gpu/a.h:3
refuses src/util/a.h '' src/util
refuses shaders/lib/a.glsl '#include "core/math.h"' shaders/lib/a.glsl:3
