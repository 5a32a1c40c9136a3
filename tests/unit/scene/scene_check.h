#pragma once
// What the tests of the loaders share: folders of small files, scenes from them, and measures of scenes.

#include "core/math.h"
#include "scene/load.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt::test {

/// A new empty folder, gone with the object.
class TempFolder {
public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  fs::path write(const std::string& name, std::string_view text) const;
  [[nodiscard]] const fs::path& path() const { return m_path; }

private:
  fs::path m_path;
};

struct Loaded {
  Scene scene;
  SceneReport report;
};
Loaded load(std::initializer_list<fs::path> files);
/// Loads `obj` as "scene.obj" beside "scene.mtl" with the text `mtl`, which it has to name itself.
Loaded loadText(std::string_view obj, std::string_view mtl = {});

/// "" when loading succeeds; else the error's text. Fails the test when it is no SceneError of exit code 2 in
/// one line.
std::string errorOf(std::initializer_list<fs::path> files);
std::string errorOfText(std::string_view obj, std::string_view mtl = {});

bool anyContains(const std::vector<std::string>& lines, std::string_view part);
std::size_t countContaining(const std::vector<std::string>& lines, std::string_view part);

Vec3d worldPosition(const Scene& scene, std::uint32_t vertex);
/// Twice the area long, towards the front.
Vec3d areaVector(const Scene& scene, const Triangle& triangle);
Vec3d centroid(const Scene& scene, const Triangle& triangle);
double totalArea(const Scene& scene);
/// The material that a name is, or a failed test.
const Material& materialNamed(const Scene& scene, std::string_view name);
std::vector<Triangle> trianglesOf(const Scene& scene, std::string_view materialName);

/// A unit square in the plane z = 0 of two triangles, front towards +z; line 5 is its only face.
inline constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// A text with kSquare, whose third corner is lifted: another square beside it is no twin.
std::string otherSquare(std::string_view text);

} // namespace vkpt::test
