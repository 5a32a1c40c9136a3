#include "unit/scene/scene_check.h"

#include <algorithm>
#include <fstream>
#include <span>

#include <gtest/gtest.h>
#include <unistd.h>

namespace vkpt::test {

TempFolder::TempFolder() {
  std::string name = (fs::temp_directory_path() / "vkpt_scene_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("no temporary folder " + name);
  }
  m_path = name;
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  fs::remove_all(m_path, ignored);
}

fs::path TempFolder::write(const std::string& name, std::string_view text) const {
  const fs::path file = m_path / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

Loaded load(std::initializer_list<fs::path> files) {
  Loaded loaded;
  loaded.scene = loadScene(std::span(files.begin(), files.size()), loaded.report);
  return loaded;
}

std::string otherSquare(std::string_view text) {
  std::string other(text);
  constexpr std::string_view kThird = "v 1 1 0";
  return other.replace(other.find(kThird), kThird.size(), "v 1 1 1");
}

Loaded loadText(std::string_view obj, std::string_view mtl) {
  const TempFolder folder;
  if (!mtl.empty()) {
    folder.write("scene.mtl", mtl);
  }
  return load({folder.write("scene.obj", obj)});
}

std::string errorOf(std::initializer_list<fs::path> files) {
  try {
    load(files);
  } catch (const SceneError& error) {
    const std::string what = error.what();
    EXPECT_EQ(static_cast<int>(error.code()), 2) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    return what;
  } catch (const std::exception& error) {
    ADD_FAILURE() << "no SceneError: " << error.what();
    return error.what();
  }
  return {};
}

std::string errorOfText(std::string_view obj, std::string_view mtl) {
  const TempFolder folder;
  if (!mtl.empty()) {
    folder.write("scene.mtl", mtl);
  }
  return errorOf({folder.write("scene.obj", obj)});
}

std::size_t countContaining(const std::vector<std::string>& lines, std::string_view part) {
  return static_cast<std::size_t>(std::ranges::count_if(
      lines, [&](const std::string& line) { return line.find(part) != std::string::npos; }));
}

bool anyContains(const std::vector<std::string>& lines, std::string_view part) {
  return countContaining(lines, part) > 0;
}

Vec3d worldPosition(const Scene& scene, std::uint32_t vertex) {
  return Vec3d(scene.positions.at(vertex)) + scene.origin;
}

Vec3d areaVector(const Scene& scene, const Triangle& t) {
  const Vec3d a = worldPosition(scene, t.vertex[0]);
  return glm::cross(worldPosition(scene, t.vertex[1]) - a, worldPosition(scene, t.vertex[2]) - a);
}

Vec3d centroid(const Scene& scene, const Triangle& t) {
  return (worldPosition(scene, t.vertex[0]) + worldPosition(scene, t.vertex[1]) +
          worldPosition(scene, t.vertex[2])) /
         3.0;
}

double totalArea(const Scene& scene) {
  double area = 0.0;
  for (const Triangle& t : scene.triangles) {
    area += 0.5 * glm::length(areaVector(scene, t));
  }
  return area;
}

const Material& materialNamed(const Scene& scene, std::string_view name) {
  const auto found = std::ranges::find(scene.materials, name, &Material::name);
  if (found == scene.materials.end()) {
    throw std::runtime_error("no material " + std::string(name));
  }
  return *found;
}

std::vector<Triangle> trianglesOf(const Scene& scene, std::string_view materialName) {
  std::vector<Triangle> chosen;
  std::ranges::copy_if(scene.triangles, std::back_inserter(chosen), [&](const Triangle& t) {
    return scene.materials.at(t.material).name == materialName;
  });
  return chosen;
}

} // namespace vkpt::test
