#pragma once
// What the tests of Nori files share.

#include "unit/scene/scene_check.h"

#include <string>
#include <string_view>

namespace vkpt::test {

/// A folder with meshes: square.obj (kSquare: z = 0, no normals), plane.obj (y = 0 from -1 to 1, normals +y).
class NoriFolder : public TempFolder {
public:
  NoriFolder();
  /// Writes `xml` as scene.xml and loads it.
  [[nodiscard]] Loaded load(std::string_view xml) const;
  /// "" when loading succeeds; else the error's text, without the folder.
  [[nodiscard]] std::string error(std::string_view xml) const;
};

inline constexpr std::string_view kNoriCamera = R"(<camera type="perspective"/>)";
inline constexpr std::string_view kNoriSquare =
    R"(<mesh type="obj"><string name="filename" value="square.obj"/></mesh>)";

/// <scene> with `body`, which starts on line 2, and after it the camera and the square where wanted.
std::string noriScene(std::string_view body, bool withCamera = true, bool withMesh = true);
/// A mesh of `file`, with more elements in it.
std::string noriMesh(std::string_view file, std::string_view more = {});
/// A scene of the square with one bsdf.
Loaded loadNoriBsdf(std::string_view bsdf);

} // namespace vkpt::test
