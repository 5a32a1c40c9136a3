#include "scene/nori_mesh.h"

#include "scene/compactor.h"
#include "scene/names.h"
#include "scene/nori_bsdf.h"
#include "scene/nori_light.h"
#include "scene/nori_object.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace vkpt {

namespace {

constexpr std::array<std::string_view, 1> kMeshTypes{"obj"};
constexpr std::array<std::string_view, 3> kMeshParts{"bsdf", "emitter", "luminaire"};

/// The side of a surface is that of its normals: two corners change places where the winding disagrees.
void faceNormals(Triangle& t, const std::vector<Vec3d>& world, const std::vector<Vec3f>& normals) {
  const Vec3d a = world[t.vertex[0]];
  const Vec3d winding = glm::cross(world[t.vertex[1]] - a, world[t.vertex[2]] - a);
  const Vec3d mean = Vec3d(normals[t.normal[0]]) + Vec3d(normals[t.normal[1]]) + Vec3d(normals[t.normal[2]]);
  if (glm::dot(winding, mean) < 0.0) {
    std::swap(t.vertex[1], t.vertex[2]);
    std::swap(t.normal[1], t.normal[2]);
  }
}

Material readMaterial(const NoriObject& mesh, const std::string& fileName) {
  const XmlElement* bsdf = mesh.onlyChild(kBsdfTags);
  Material material = bsdf == nullptr ? defaultNoriMaterial() : readNoriBsdf(*bsdf, mesh.report());
  if (bsdf == nullptr) {
    material.where = mesh.where();
  }
  material.name = fs::path(fileName).stem().string();
  const XmlElement* light = mesh.onlyChild(kNoriLightTags);
  if (light != nullptr) {
    material.emission = readNoriAreaLight(*light, mesh.report());
  }
  return material;
}

} // namespace

const NoriMeshFiles::File& NoriMeshFiles::open(const std::string& fileName, const SourceLocation& where) {
  const fs::path path = pathBeside(m_source, fileName);
  const auto known = m_files.find(path);
  if (known != m_files.end()) {
    return known->second;
  }
  const auto text = openBeside(m_source, fileName);
  if (!text) {
    throw SceneError(
        where, fmt::format("there is no file '{}' that can be read; names are relative to the scene's folder",
                           shown(fileName)));
  }
  File file{text->name, readObj(*text, m_report.warnings), {}};
  file.faces = cutFaces(file.name, file.mesh, m_report.warnings);
  return m_files.emplace(path, std::move(file)).first->second;
}

void NoriGeometry::add(const XmlElement& mesh, Scene& scene) {
  static_cast<void>(noriTypeIndex(mesh, kMeshTypes));
  NoriObject object(mesh, kMeshParts, m_report);
  const auto fileName = object.text("filename");
  if (!fileName) {
    throw SceneError(mesh.where, "a mesh without a file; give <string name=\"filename\" value=\"a.obj\"/>");
  }
  const auto toWorld = object.transform("toWorld");
  const NoriMeshFiles::File& file = m_files.open(*fileName, object.where("filename"));
  scene.materials.push_back(readMaterial(object, *fileName));
  append(file, toWorld.value_or(glm::dmat4(1.0)), object.where("toWorld"), scene);
  object.warnOfUnread();
}

void NoriGeometry::append(const NoriMeshFiles::File& file, const glm::dmat4& toWorld,
                          const SourceLocation& where, Scene& scene) {
  const ObjMesh& mesh = file.mesh;
  if (m_world.size() + mesh.positions.size() >= kNoNormal ||
      scene.normals.size() + mesh.normals.size() >= kNoNormal) {
    throw SceneError(where, "more than 2^32 vertices; split the scene");
  }
  const glm::dmat3 normalToWorld = glm::transpose(glm::inverse(glm::dmat3(toWorld)));
  const auto appendVertex = [&](std::uint32_t i) {
    m_world.emplace_back(toWorld * glm::dvec4(mesh.positions[i], 1.0));
    const Vec3d& p = m_world.back();
    if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kLargestCoordinate)) {
      throw SceneError(
          where, fmt::format("toWorld moves a vertex beyond {:g}; give smaller numbers", kLargestCoordinate));
    }
    return static_cast<std::uint32_t>(m_world.size() - 1);
  };
  const auto appendNormal = [&](std::uint32_t i) {
    scene.normals.emplace_back(glm::normalize(normalToWorld * mesh.normals[i]));
    return static_cast<std::uint32_t>(scene.normals.size() - 1);
  };
  Compactor vertices(mesh.positions.size());
  Compactor normals(mesh.normals.size());
  m_parts.push_back({file.name, scene.triangles.size(), file.faces.lines});
  for (Triangle t : file.faces.triangles) {
    t.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    t.uv = {kNoUv, kNoUv, kNoUv}; // Nori's course has no textures
    const bool hasNormals = t.normal[0] != kNoNormal;
    for (std::size_t i = 0; i < 3; ++i) {
      t.vertex[i] = vertices(t.vertex[i], appendVertex);
      t.normal[i] = hasNormals ? normals(t.normal[i], appendNormal) : kNoNormal;
    }
    if (hasNormals) {
      faceNormals(t, m_world, scene.normals);
    }
    scene.triangles.push_back(t);
  }
}

void NoriGeometry::finish(Scene& scene) const {
  recentre(scene, m_world);
  dropUseless(scene, m_parts, m_report);
}

} // namespace vkpt
