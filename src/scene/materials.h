#pragma once
// The materials of a scene: MTL libraries looked up by name, converted when first used.

#include "scene/mtl_reader.h"
#include "scene/obj_reader.h"
#include "scene/scene.h"
#include "scene/sources.h"
#include "scene/texture_table.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vkpt {

/// Only what a face uses enters the scene and can warn: libraries often define more than that.
class MaterialTable {
public:
  /// Fills the materials and the textures of `scene`.
  MaterialTable(Scene& scene, SceneReport& report)
      : m_materials(scene.materials), m_textures(scene.textures, report), m_report(report) {}

  /// For every entry of `mesh.materials` that a face uses its index in the scene, for the others 0.
  std::vector<std::uint32_t> resolve(const SceneText& source, const ObjMesh& mesh);

private:
  struct Library {
    std::vector<MtlMaterial> materials;
    std::map<std::string, std::size_t> byName;            ///< of two with one name the first
    std::vector<std::optional<std::uint32_t>> sceneIndex; ///< where it is in the scene, once used
  };

  std::vector<Library*> openLibraries(const SceneText& source, const ObjMesh& mesh);
  std::vector<std::string> libraryNames(const SceneText& source, const std::string& arguments) const;
  Library& library(SceneText text);
  std::uint32_t lookUp(const std::vector<Library*>& libraries, const SceneText& source,
                       const ObjMaterialUse& use);
  std::uint32_t defaultMaterial(const SourceLocation& where);
  std::uint32_t add(Material material);

  std::vector<Material>& m_materials;
  TextureTable m_textures;
  SceneReport& m_report;
  std::map<std::string, Library> m_libraries; ///< by the text's name; several OBJ files may share one
  std::set<std::string> m_unreadKeys;         ///< already warned about
  std::optional<std::uint32_t> m_default;
};

/// The Material that `mtl` means, by the tables of mtl_table.h; says in `report` where it had to guess.
/// Throws SceneError at a number that its shader cannot take.
Material convertMaterial(const MtlMaterial& mtl, TextureTable& textures, SceneReport& report);

} // namespace vkpt
