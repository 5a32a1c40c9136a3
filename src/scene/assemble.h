#pragma once
// Several OBJ texts into one Scene.

#include "core/math.h"
#include "scene/materials.h"
#include "scene/obj_reader.h"
#include "scene/scene.h"
#include "scene/sources.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vkpt {

class SceneAssembler {
public:
  explicit SceneAssembler(SceneReport& report) : m_report(report), m_materials(m_scene, report) {}

  /// Reads, places and triangulates one text.
  void add(const SceneText& source);
  /// Recentres, drops what has no area, fits the camera.
  Scene finish();

private:
  /// The triangles of one file: where they start, and the line of each.
  struct File {
    std::string name;
    std::size_t firstTriangle = 0;
    std::vector<std::uint32_t> lines;
  };

  void applyPlacement(const SceneText& source, ObjMesh& mesh);
  std::vector<Triangle> cutFaces(const SceneText& source, const ObjMesh& mesh, File& file);
  void smooth(const SceneText& source, ObjMesh& mesh, std::vector<Triangle>& triangles);
  void layTextures(const SceneText& source, ObjMesh& mesh, const File& file,
                   std::vector<Triangle>& triangles);
  void append(const ObjMesh& mesh, std::vector<Triangle> triangles);
  void dropDegenerate();
  void note(std::string text);

  SceneReport& m_report;
  Scene m_scene;
  MaterialTable m_materials;
  std::vector<Vec3d> m_world; ///< Scene::positions before recentring
  std::vector<File> m_files;
};

} // namespace vkpt
