#pragma once
// One OBJ text as polygons with checked indices. Nothing is placed, triangulated or dropped here.

#include "core/error.h"
#include "core/math.h"
#include "scene/scene.h"
#include "scene/sources.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vkpt {

struct ObjCorner {
  std::uint32_t vertex;
  std::uint32_t normal; ///< kNoNormal: the face has none here
  std::uint32_t uv;     ///< kNoUv: the face has none here
};

struct ObjFace {
  std::size_t firstCorner;
  std::uint32_t cornerCount; ///< at least 3
  std::uint32_t material;    ///< index into ObjMesh::materials
  std::uint32_t line;
};

/// A name that a `usemtl` gives.
struct ObjMaterialUse {
  std::string name;
  std::size_t line = 0;
};

struct ObjMesh {
  std::vector<Vec3d> positions;          ///< finite
  std::vector<Vec3d> normals;            ///< unit length, or zero where the file's is none
  std::vector<Vec2f> uvs;                ///< finite
  std::vector<ObjCorner> corners;        ///< indices in range
  std::vector<ObjFace> faces;            ///< at least one
  std::vector<ObjMaterialUse> materials; ///< each name once; the first stands for faces before any `usemtl`
  std::vector<ObjMaterialUse> libraries; ///< names and lines of the `mtllib` statements
};

/// Coordinates beyond this are refused: squares of them leave the range of float.
inline constexpr double kLargestCoordinate = 1e18;

/// Throws SceneError; odd but harmless things become warnings.
ObjMesh readObj(const SceneText& source, std::vector<std::string>& warnings);

} // namespace vkpt
