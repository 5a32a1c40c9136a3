#pragma once
// Several OBJ texts into one Scene.

#include "core/math.h"
#include "scene/cut_faces.h"
#include "scene/materials.h"
#include "scene/obj_reader.h"
#include "scene/recentre.h"
#include "scene/scene.h"
#include "scene/sources.h"

#include <string>
#include <vector>

namespace vkpt {

class SceneAssembler {
public:
  explicit SceneAssembler(SceneReport& report) : m_report(report), m_materials(m_scene, report) {}

  /// Reads, places and triangulates one text.
  void add(const SceneText& source);
  /// Recentres, drops what has no area or is there twice, fits the camera.
  Scene finish();

private:
  void applyPlacement(const SceneText& source, ObjMesh& mesh);
  void smooth(const SceneText& source, ObjMesh& mesh, std::vector<Triangle>& triangles);
  void layTextures(const SceneText& source, ObjMesh& mesh, CutFaces& faces);
  void append(const ObjMesh& mesh, std::vector<Triangle> triangles);
  void note(std::string text);

  SceneReport& m_report;
  Scene m_scene;
  MaterialTable m_materials;
  std::vector<Vec3d> m_world; ///< Scene::positions before recentring
  std::vector<MeshPart> m_parts;
};

} // namespace vkpt
