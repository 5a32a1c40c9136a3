#include "scene/materials.h"

#include "scene/names.h"
#include "scene/statements.h"

#include <algorithm>

#include <fmt/format.h>

namespace vkpt {

std::vector<std::uint32_t> MaterialTable::resolve(const SceneText& source, const ObjMesh& mesh) {
  const std::vector<Library*> libraries = openLibraries(source, mesh);
  std::vector<bool> used(mesh.materials.size(), false);
  for (const ObjFace& face : mesh.faces) {
    used[face.material] = true;
  }
  std::vector<std::uint32_t> indices(mesh.materials.size(), 0);
  for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
    if (used[i]) {
      indices[i] = i == 0 ? defaultMaterial({source.name}) : lookUp(libraries, source, mesh.materials[i]);
    }
  }
  return indices;
}

std::vector<MaterialTable::Library*> MaterialTable::openLibraries(const SceneText& source,
                                                                  const ObjMesh& mesh) {
  std::vector<Library*> libraries;
  for (const ObjMaterialUse& use : mesh.libraries) {
    for (const std::string& name : libraryNames(source, use.name)) {
      if (auto text = openBeside(source, name)) {
        libraries.push_back(&library(std::move(*text)));
      } else {
        m_report.warnings.push_back(
            fmt::format("{}: material file '{}' cannot be read; its materials become grey (Kd 0.8)",
                        SourceLocation{source.name, use.line}.text(), shown(name)));
      }
    }
  }
  return libraries;
}

/// `mtllib` takes several names; one name may hold blanks, and some modellers write backslashes.
std::vector<std::string> MaterialTable::libraryNames(const SceneText& source,
                                                     const std::string& arguments) const {
  std::string slashed = arguments;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  if (slashed.empty() || openBeside(source, arguments)) {
    return {arguments};
  }
  if (openBeside(source, slashed)) {
    return {slashed};
  }
  std::vector<std::string_view> words;
  splitWords(slashed, words);
  return {words.begin(), words.end()};
}

MaterialTable::Library& MaterialTable::library(SceneText text) {
  const auto [entry, isNew] = m_libraries.try_emplace(text.name);
  Library& lib = entry->second;
  if (isNew) {
    lib.materials = readMtl(text, m_report.warnings);
    lib.sceneIndex.resize(lib.materials.size());
    for (std::size_t i = 0; i < lib.materials.size(); ++i) {
      lib.byName.emplace(lib.materials[i].name, i);
    }
  }
  return lib;
}

std::uint32_t MaterialTable::lookUp(const std::vector<Library*>& libraries, const SceneText& source,
                                    const ObjMaterialUse& use) {
  for (Library* lib : libraries) {
    const auto found = lib->byName.find(use.name);
    if (found == lib->byName.end()) {
      continue;
    }
    std::optional<std::uint32_t>& index = lib->sceneIndex[found->second];
    if (!index) {
      const MtlMaterial& mtl = lib->materials[found->second];
      for (const UnreadKey& unread : mtl.unread) {
        if (m_unreadKeys.insert(unread.name).second) {
          m_report.warnings.push_back(
              fmt::format("{}: {}", SourceLocation{mtl.where.file, unread.line}.text(), unread.warning));
        }
      }
      index = add(convertMaterial(mtl, m_textures, m_report));
    }
    return *index;
  }
  std::vector<std::string_view> known;
  for (const Library* lib : libraries) {
    for (const MtlMaterial& mtl : lib->materials) {
      known.push_back(mtl.name);
    }
  }
  const SourceLocation where{source.name, use.line};
  m_report.warnings.push_back(fmt::format("{}: unknown material '{}'; taken as grey (Kd 0.8){}", where.text(),
                                          shown(use.name), didYouMean(use.name, known)));
  return defaultMaterial(where);
}

std::uint32_t MaterialTable::defaultMaterial(const SourceLocation& where) {
  if (!m_default) {
    Material grey;
    grey.name = "default";
    grey.where = where;
    grey.reflectance = Vec3f(0.8F);
    m_default = add(std::move(grey));
  }
  return *m_default;
}

std::uint32_t MaterialTable::add(Material material) {
  m_materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(m_materials.size() - 1);
}

} // namespace vkpt
