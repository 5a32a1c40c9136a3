#pragma once
// Nori's `mesh` objects: OBJ files, placed by their toWorld.

#include "scene/cut_faces.h"
#include "scene/nori_xml.h"
#include "scene/obj_reader.h"
#include "scene/recentre.h"
#include "scene/scene.h"
#include "scene/sources.h"

#include <map>
#include <string>
#include <vector>

namespace vkpt {

/// The OBJ files of one XML file, each read once however many meshes are made of it.
class NoriMeshFiles {
public:
  struct File {
    std::string name;
    ObjMesh mesh;
    CutFaces faces;
  };

  NoriMeshFiles(const SceneText& source, SceneReport& report) : m_source(source), m_report(report) {}

  /// `where` is that of the name. Throws SceneError where there is no such file.
  const File& open(const std::string& fileName, const SourceLocation& where);

private:
  const SceneText& m_source;
  SceneReport& m_report;
  std::map<fs::path, File> m_files;
};

/// Collects the meshes of one scene.
class NoriGeometry {
public:
  NoriGeometry(NoriMeshFiles& files, SceneReport& report) : m_files(files), m_report(report) {}

  void add(const XmlElement& mesh, Scene& scene);
  /// Recentres, drops what has no area.
  void finish(Scene& scene) const;

private:
  void append(const NoriMeshFiles::File& file, const glm::dmat4& toWorld, const SourceLocation& where,
              Scene& scene);

  NoriMeshFiles& m_files;
  SceneReport& m_report;
  std::vector<Vec3d> m_world; ///< Scene::positions before recentring
  std::vector<MeshPart> m_parts;
};

} // namespace vkpt
