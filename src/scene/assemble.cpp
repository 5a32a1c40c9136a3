#include "scene/assemble.h"

#include "scene/placement.h"
#include "scene/polygon.h"
#include "scene/smooth_normals.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace vkpt {

namespace {

/// ab == cd in exact arithmetic.
bool sameProducts(double a, double b, double c, double d) {
  const double ab = a * b;
  const double cd = c * d;
  return ab == cd && std::fma(a, b, -ab) == std::fma(c, d, -cd);
}

/// Exact for what the renderer gets, the float coordinates, unless the coordinates of one corner are 2^29
/// times those of another and their difference is rounded.
bool hasNoArea(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const Vec3d u = Vec3d(b) - Vec3d(a);
  const Vec3d v = Vec3d(c) - Vec3d(a);
  return sameProducts(u.x, v.y, u.y, v.x) && sameProducts(u.y, v.z, u.z, v.y) &&
         sameProducts(u.z, v.x, u.x, v.z);
}

std::string stem(const SceneText& source) { return fs::path(source.fileName).stem().string(); }

/// Maps indices of a file to the scene's, in the order of first use.
class Compactor {
public:
  explicit Compactor(std::size_t count) : m_map(count, kUnused) {}

  template<class Append>
  std::uint32_t operator()(std::uint32_t index, const Append& append) {
    if (m_map[index] == kUnused) {
      m_map[index] = append(index);
    }
    return m_map[index];
  }

private:
  static constexpr std::uint32_t kUnused = 0xFFFFFFFFU;
  std::vector<std::uint32_t> m_map;
};

} // namespace

void SceneAssembler::add(const SceneText& source) {
  ObjMesh mesh = readObj(source, m_report.warnings);
  const std::vector<std::uint32_t> materials = m_materials.resolve(source, mesh);
  for (ObjFace& face : mesh.faces) {
    face.material = materials[face.material];
  }
  applyPlacement(source, mesh);
  File file{source.name, m_scene.triangles.size(), {}};
  std::vector<Triangle> triangles = cutFaces(source, mesh, file);
  if (mesh.normals.empty()) {
    smooth(source, mesh, triangles);
  }
  layTextures(source, mesh, file, triangles);
  append(mesh, std::move(triangles));
  m_files.push_back(std::move(file));
  m_scene.name.append(m_scene.name.empty() ? "" : "+").append(stem(source));
}

void SceneAssembler::note(std::string text) {
  if (std::ranges::find(m_report.notes, text) == m_report.notes.end()) {
    m_report.notes.push_back(std::move(text));
  }
}

void SceneAssembler::applyPlacement(const SceneText& source, ObjMesh& mesh) {
  const Placement placement = placementFor(source.fileName);
  if (placement.note.empty()) {
    return;
  }
  note(std::string(placement.note));
  for (Vec3d& p : mesh.positions) {
    p = placement.position(p);
  }
  for (Vec3d& n : mesh.normals) {
    n = placement.direction(n);
  }
}

std::vector<Triangle> SceneAssembler::cutFaces(const SceneText& source, const ObjMesh& mesh, File& file) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.faces.size());
  std::vector<Vec3d> outline;
  std::vector<std::array<std::uint32_t, 3>> cut;
  for (const ObjFace& face : mesh.faces) {
    const std::span<const ObjCorner> corners(mesh.corners.data() + face.firstCorner, face.cornerCount);
    outline.clear();
    for (const ObjCorner& corner : corners) {
      outline.push_back(mesh.positions[corner.vertex]);
    }
    cut.clear();
    const PolygonKind kind = triangulate(outline, cut);
    const SourceLocation where{source.name, face.line};
    if (kind == PolygonKind::TooLarge) {
      throw SceneError(where,
                       fmt::format("a concave face with {} corners; at most {}, so cut it into smaller ones",
                                   corners.size(), kMostConcaveCorners));
    }
    if (kind == PolygonKind::Crossed) {
      m_report.warnings.push_back(
          fmt::format("{}: the face crosses itself or is a line; cut into a fan", where.text()));
    }
    for (const auto& t : cut) {
      Triangle triangle;
      triangle.material = face.material;
      bool hasNormals = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const ObjCorner& corner = corners[t[i]];
        triangle.vertex[i] = corner.vertex;
        triangle.normal[i] = corner.normal;
        triangle.uv[i] = corner.uv;
        hasNormals = hasNormals && corner.normal != kNoNormal && mesh.normals[corner.normal] != Vec3d(0.0);
      }
      if (!hasNormals) {
        triangle.normal = {kNoNormal, kNoNormal, kNoNormal};
      }
      triangles.push_back(triangle);
      file.lines.push_back(face.line);
    }
  }
  return triangles;
}

void SceneAssembler::smooth(const SceneText& source, ObjMesh& mesh, std::vector<Triangle>& triangles) {
  std::size_t count = 0;
  mesh.normals = makeSmoothNormals(mesh.positions, triangles, count);
  m_report.inventedNormals += count;
  if (count > 0) {
    note(fmt::format("{}: no normals in the file, smooth ones made for {} vertices", source.name, count));
  }
}

/// Texture coordinates where there is a texture, and nowhere else.
void SceneAssembler::layTextures(const SceneText& source, ObjMesh& mesh, const File& file,
                                 std::vector<Triangle>& triangles) {
  const auto zero = static_cast<std::uint32_t>(mesh.uvs.size());
  std::size_t missing = 0;
  std::size_t firstLine = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangle& t = triangles[i];
    if (m_scene.materials[t.material].texture == kNoTexture) {
      t.uv = {kNoUv, kNoUv, kNoUv};
    } else if (std::ranges::find(t.uv, kNoUv) != t.uv.end()) {
      t.uv = {zero, zero, zero};
      if (missing++ == 0) {
        firstLine = file.lines[i];
      }
    }
  }
  if (missing > 0) {
    mesh.uvs.emplace_back(0.0F);
    m_report.warnings.push_back(
        fmt::format("{}: {} triangle{} with a texture but no texture coordinates{}; taken as 0 0",
                    SourceLocation{source.name, firstLine}.text(), missing, missing == 1 ? "" : "s",
                    missing == 1 ? "" : ", the first here"));
  }
}

void SceneAssembler::append(const ObjMesh& mesh, std::vector<Triangle> triangles) {
  if (m_world.size() + mesh.positions.size() >= kNoNormal ||
      m_scene.normals.size() + mesh.normals.size() >= kNoNormal ||
      m_scene.uvs.size() + mesh.uvs.size() >= kNoUv) {
    throw SceneError({m_scene.name}, "more than 2^32 vertices; split the scene");
  }
  Compactor vertices(mesh.positions.size());
  Compactor normals(mesh.normals.size());
  Compactor uvs(mesh.uvs.size());
  const auto appendVertex = [&](std::uint32_t i) {
    m_world.push_back(mesh.positions[i]);
    return static_cast<std::uint32_t>(m_world.size() - 1);
  };
  const auto appendNormal = [&](std::uint32_t i) {
    m_scene.normals.emplace_back(mesh.normals[i]);
    return static_cast<std::uint32_t>(m_scene.normals.size() - 1);
  };
  const auto appendUv = [&](std::uint32_t i) {
    m_scene.uvs.push_back(mesh.uvs[i]);
    return static_cast<std::uint32_t>(m_scene.uvs.size() - 1);
  };
  for (Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      t.vertex[i] = vertices(t.vertex[i], appendVertex);
      t.normal[i] = t.normal[i] == kNoNormal ? kNoNormal : normals(t.normal[i], appendNormal);
      t.uv[i] = t.uv[i] == kNoUv ? kNoUv : uvs(t.uv[i], appendUv);
    }
    m_scene.triangles.push_back(t);
  }
}

Scene SceneAssembler::finish() {
  Box3d box;
  for (const Vec3d& p : m_world) {
    box.extend(p);
  }
  m_scene.origin = box.centre();
  m_scene.positions.reserve(m_world.size());
  for (const Vec3d& p : m_world) {
    m_scene.positions.emplace_back(p - m_scene.origin);
  }
  m_scene.camera = fitCamera(box);
  dropDegenerate();
  return std::move(m_scene);
}

void SceneAssembler::dropDegenerate() {
  std::vector<Triangle> kept;
  kept.reserve(m_scene.triangles.size());
  for (const File& file : m_files) {
    std::size_t dropped = 0;
    std::size_t firstLine = 0;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const Triangle& t = m_scene.triangles[file.firstTriangle + i];
      const auto& p = m_scene.positions;
      if (!hasNoArea(p[t.vertex[0]], p[t.vertex[1]], p[t.vertex[2]])) {
        kept.push_back(t);
      } else if (dropped++ == 0) {
        firstLine = file.lines[i];
      }
    }
    if (dropped > 0) {
      m_report.droppedDegenerate += dropped;
      m_report.warnings.push_back(
          fmt::format("{}: {} triangle{} of zero area dropped{}", SourceLocation{file.name, firstLine}.text(),
                      dropped, dropped == 1 ? "" : "s", dropped == 1 ? "" : ", the first here"));
    }
  }
  if (kept.empty()) {
    throw SceneError({m_files.front().name},
                     fmt::format("no faces with an area (all {} triangles have none); "
                                 "give at least one",
                                 m_scene.triangles.size()));
  }
  m_scene.triangles = std::move(kept);
}

} // namespace vkpt
