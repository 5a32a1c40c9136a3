#include "scene/cut_faces.h"

#include "scene/polygon.h"

#include <array>
#include <span>

#include <fmt/format.h>

namespace vkpt {

namespace {

Triangle triangleOf(const ObjMesh& mesh, std::span<const ObjCorner> corners,
                    const std::array<std::uint32_t, 3>& cut) {
  Triangle triangle;
  bool hasNormals = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const ObjCorner& corner = corners[cut[i]];
    triangle.vertex[i] = corner.vertex;
    triangle.normal[i] = corner.normal;
    triangle.uv[i] = corner.uv;
    hasNormals = hasNormals && corner.normal != kNoNormal && mesh.normals[corner.normal] != Vec3d(0.0);
  }
  if (!hasNormals) {
    triangle.normal = {kNoNormal, kNoNormal, kNoNormal};
  }
  return triangle;
}

} // namespace

CutFaces cutFaces(const std::string& name, const ObjMesh& mesh, std::vector<std::string>& warnings) {
  CutFaces result;
  result.triangles.reserve(mesh.faces.size());
  result.lines.reserve(mesh.faces.size());
  std::vector<Vec3d> outline;
  std::vector<std::array<std::uint32_t, 3>> cuts;
  for (const ObjFace& face : mesh.faces) {
    const std::span<const ObjCorner> corners(mesh.corners.data() + face.firstCorner, face.cornerCount);
    outline.clear();
    for (const ObjCorner& corner : corners) {
      outline.push_back(mesh.positions[corner.vertex]);
    }
    cuts.clear();
    const PolygonKind kind = triangulate(outline, cuts);
    const SourceLocation where{name, face.line};
    if (kind == PolygonKind::TooLarge) {
      throw SceneError(where,
                       fmt::format("a concave face with {} corners; at most {}, so cut it into smaller ones",
                                   corners.size(), kMostConcaveCorners));
    }
    if (kind == PolygonKind::Crossed) {
      warnings.push_back(
          fmt::format("{}: the face crosses itself or is a line; cut into a fan", where.text()));
    }
    for (const auto& cut : cuts) {
      result.triangles.push_back(triangleOf(mesh, corners, cut));
      result.triangles.back().material = face.material;
      result.lines.push_back(face.line);
    }
  }
  return result;
}

} // namespace vkpt
