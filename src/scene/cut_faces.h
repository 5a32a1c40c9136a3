#pragma once
// The polygons of an OBJ file as triangles that still index the file's lists.

#include "scene/obj_reader.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vkpt {

struct CutFaces {
  std::vector<Triangle> triangles;  ///< normals: all three, or none where one is missing or zero
  std::vector<std::uint32_t> lines; ///< of each triangle in the file
};

/// `name` is the file's, for messages. Throws SceneError at a concave face with too many corners.
CutFaces cutFaces(const std::string& name, const ObjMesh& mesh, std::vector<std::string>& warnings);

} // namespace vkpt
