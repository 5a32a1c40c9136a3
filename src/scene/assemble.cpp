#include "scene/assemble.h"

#include "scene/compactor.h"
#include "scene/placement.h"
#include "scene/smooth_normals.h"

#include <algorithm>

#include <fmt/format.h>

namespace vkpt {

namespace {

std::string stem(const SceneText& source) { return fs::path(source.fileName).stem().string(); }

} // namespace

void SceneAssembler::add(const SceneText& source) {
  ObjMesh mesh = readObj(source, m_report.warnings);
  const std::vector<std::uint32_t> materials = m_materials.resolve(source, mesh);
  for (ObjFace& face : mesh.faces) {
    face.material = materials[face.material];
  }
  applyPlacement(source, mesh);
  CutFaces faces = cutFaces(source.name, mesh, m_report.warnings);
  if (mesh.normals.empty()) {
    smooth(source, mesh, faces.triangles);
  }
  layTextures(source, mesh, faces);
  m_parts.push_back({source.name, m_scene.triangles.size(), std::move(faces.lines)});
  append(mesh, std::move(faces.triangles));
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

void SceneAssembler::smooth(const SceneText& source, ObjMesh& mesh, std::vector<Triangle>& triangles) {
  std::size_t count = 0;
  mesh.normals = makeSmoothNormals(mesh.positions, triangles, count);
  m_report.inventedNormals += count;
  if (count > 0) {
    note(fmt::format("{}: no normals in the file, smooth ones made for {} vertices", source.name, count));
  }
}

/// Texture coordinates where there is a texture, and nowhere else.
void SceneAssembler::layTextures(const SceneText& source, ObjMesh& mesh, CutFaces& faces) {
  const auto zero = static_cast<std::uint32_t>(mesh.uvs.size());
  std::size_t missing = 0;
  std::size_t firstLine = 0;
  for (std::size_t i = 0; i < faces.triangles.size(); ++i) {
    Triangle& t = faces.triangles[i];
    if (m_scene.materials[t.material].texture == kNoTexture) {
      t.uv = {kNoUv, kNoUv, kNoUv};
    } else if (std::ranges::find(t.uv, kNoUv) != t.uv.end()) {
      t.uv = {zero, zero, zero};
      if (missing++ == 0) {
        firstLine = faces.lines[i];
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
  note("OBJ conventions: both sides scatter, smooth normals where a file has none, radiance not scaled at "
       "refraction");
  m_scene.camera = fitCamera(recentre(m_scene, m_world));
  dropUseless(m_scene, m_parts, m_report);
  return std::move(m_scene);
}

} // namespace vkpt
