#include "unit/scene/scene_check.h"

#include "scene/sources.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

/// Stands in another folder for as long as it lives.
class WorkingFolder {
public:
  explicit WorkingFolder(const fs::path& path) : m_before(fs::current_path()) { fs::current_path(path); }
  ~WorkingFolder() { fs::current_path(m_before); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

private:
  fs::path m_before;
};

TEST(Builtin, EveryListedSceneLoads) {
  ASSERT_GE(builtinScenes().size(), 2U);
  for (const BuiltinScene& builtin : builtinScenes()) {
    const auto [scene, report] = load({builtin.name});
    EXPECT_FALSE(scene.triangles.empty()) << builtin.name;
    EXPECT_TRUE(report.warnings.empty()) << builtin.name;
    EXPECT_FALSE(builtin.description.empty());
    EXPECT_EQ(countContaining(report.notes, "Cornell rule"), 1U) << "said once for all files";
  }
}

TEST(Builtin, NoSceneIsTheCornellBoxWithBlocks) {
  const auto none = load({});
  const auto named = load({"cornell"});
  const auto files = load({"CornellBox.obj", "CornellBlocks.obj"});
  EXPECT_EQ(none.scene.triangles.size(), 32U);
  EXPECT_EQ(none.scene.positions, named.scene.positions);
  EXPECT_EQ(none.scene.positions, files.scene.positions);
  EXPECT_EQ(none.scene.name, "CornellBox+CornellBlocks");
  EXPECT_EQ(none.scene.materials.size(), 4U) << "both files use one MTL file";
}

TEST(Builtin, AssetsStandInForMissingFilesAndSaySo) {
  const TempFolder folder;
  const WorkingFolder here(folder.path());
  EXPECT_TRUE(anyContains(load({"CornellBox.obj"}).report.notes, "CornellBox.obj: built in"));
  EXPECT_FALSE(anyContains(load({"cornell"}).report.notes, "built in"));
  EXPECT_NE(errorOf({"CornellBox.mtl"}), "");
  EXPECT_NE(errorOf({folder.path() / "CornellBox.obj"}), "") << "a path is no bare name";
}

TEST(Builtin, AFileOfTheNameWins) {
  const TempFolder folder;
  folder.write("CornellBox.obj", kSquare);
  const WorkingFolder here(folder.path());
  const auto box = load({"CornellBox.obj"});
  EXPECT_EQ(box.scene.triangles.size(), 2U);
  EXPECT_FALSE(anyContains(box.report.notes, "built in"));
  folder.write("cornell/other.txt", "");
  EXPECT_EQ(load({"cornell"}).scene.triangles.size(), 32U) << "a folder does not";
  EXPECT_EQ(load({}).scene.triangles.size(), 32U) << "the default scene is never a file";
}

TEST(Builtin, EmbeddedTextsAreThoseOfTheAssets) {
  for (const EmbeddedAsset& asset : embeddedAssets()) {
    std::ostringstream text;
    text << std::ifstream(fs::path(VKPT_SOURCE_DIR) / "assets" / asset.name, std::ios::binary).rdbuf();
    EXPECT_TRUE(text.str() == asset.text) << asset.name;
  }
}

TEST(Builtin, ErrorsAndMaterialsNameTheBuiltInFile) {
  EXPECT_TRUE(load({"cornell"}).scene.materials.at(0).where.text().starts_with("builtin:CornellBox.mtl:"));
}

TEST(SeveralFiles, AreOneScene) {
  const TempFolder folder;
  const auto [scene, report] =
      load({folder.write("a.obj", kSquare), "cornell", folder.write("sub/b.obj", otherSquare(kSquare))});
  EXPECT_EQ(scene.triangles.size(), 36U);
  EXPECT_EQ(scene.name, "a+CornellBox+CornellBlocks+b");
  // Floats about the origin: coordinates below 16 are rounded by less than 1e-6.
  EXPECT_LT(glm::length(worldPosition(scene, scene.triangles.back().vertex[0])), 2e-6);
}

TEST(SeveralFiles, IndicesAndMissingNormalsAreEachFilesOwn) {
  const TempFolder folder;
  const auto [scene, report] =
      load({folder.write("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 .3\nv 0 1 0\nf 1 2 3 4\n"),
            folder.write("given.obj", "v 5 0 0\nv 6 0 0\nv 6 1 0\nvn 1 0 0\nf -3//1 -2//1 -1//1\n")});
  ASSERT_EQ(scene.triangles.size(), 3U);
  EXPECT_EQ(report.inventedNormals, 4U) << "a vn in one file leaves the other without";
  EXPECT_EQ(scene.normals.at(scene.triangles[2].normal[0]), Vec3f(1, 0, 0));
  EXPECT_NEAR(worldPosition(scene, scene.triangles[2].vertex[0]).x, 5.0, 1e-6);
}

} // namespace
} // namespace vkpt::test
