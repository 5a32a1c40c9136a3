// What is odd but can be rendered: a warning that names it, and exit code 0; and faults, which are counted.

#include "cli/command.h"
#include "cli/small_scenes.h"
#include "film/image.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

bool anyContains(const std::vector<std::string>& lines, const std::string& part) {
  return std::ranges::any_of(lines, [&](const auto& l) { return l.find(part) != std::string::npos; });
}

float centre(const Image& image, const char* channel) {
  return image.find(channel)->values[image.pixelCount() / 2];
}

TEST(Warned, MissingMaterialsBecomeGrey) {
  const WorkFolder folder;
  folder.write("square.obj", "mtllib gone.mtl\nusemtl brick\n" + kSquare);
  const CommandResult r =
      vkpt({"square.obj", "--frames", "2", "--size", "9x9", "--background", kWhite, "-o", "x.exr"},
           {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_TRUE(r.errors().empty()) << r.err;
  EXPECT_EQ(r.warnings().size(), 2U) << r.err;
  EXPECT_TRUE(anyContains(r.warnings(), "square.obj:1: material file 'gone.mtl' cannot be read")) << r.err;
  EXPECT_TRUE(anyContains(r.warnings(), "square.obj:2: unknown material 'brick'; taken as grey (Kd 0.8)"));
  // Alone before a background of 1, every path gives the albedo.
  const Image image = readImage(folder / "x.exr");
  for (const char* channel : {"R", "G", "B"})
    EXPECT_FLOAT_EQ(centre(image, channel), 0.8F) << channel;
  EXPECT_FLOAT_EQ(centre(image, "stderr.R"), 0.0F);
}

TEST(Warned, DegenerateTrianglesAreDroppedAndCounted) {
  const WorkFolder folder;
  folder.write("square.obj", kSquare + "f 1 1 2\nf 1 2 2\n");
  const CommandResult r =
      vkpt({"square.obj", "--frames", "1", "--size", "8x8", "--background", kWhite, "--stats", "s.json"},
           {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_TRUE(anyContains(r.warnings(), "square.obj:6: 2 triangles of zero area dropped")) << r.err;
  EXPECT_EQ(folder.json("s.json")["droppedDegenerate"], 2);
  EXPECT_EQ(folder.json("s.json")["warnings"].size(), 1U);
}

TEST(Warned, ASceneWithoutLightIsBlackAndSaysWhy) {
  const WorkFolder folder;
  folder.write("square.obj", kSquare);
  const CommandResult r =
      vkpt({"square.obj", "--frames", "2", "--size", "8x8", "--stats", "s.json", "-o", "x.png"},
           {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_TRUE(anyContains(r.warnings(),
                          "no light: no material emits (Ke, or the framework's Ka) and there is "
                          "no --background; the image will be black"))
      << r.err;
  const auto stats = folder.json("s.json");
  EXPECT_EQ(stats["mean"], nlohmann::json({0.0, 0.0, 0.0}));
  EXPECT_EQ(stats["error"]["relative"], 0.0);
  const Image image = readImage(folder / "x.png");
  for (const float value : image.find("R")->values)
    EXPECT_EQ(value, 0.0F);
}

TEST(Warned, QuietSaysNothing) {
  const WorkFolder folder;
  folder.write("square.obj", kSquare);
  const CommandResult r =
      vkpt({"square.obj", "--frames", "1", "--size", "8x8", "--quiet"}, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0);
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"square.obj", "vkpt.png"}));
}

/// More triangles in one place than a traversal may look at: no tree can part them.
TEST(Warned, FaultsAreCountedAndTheImageIsWritten) {
  const WorkFolder folder;
  folder.write("pile.obj", concentric(40000));
  const CommandResult r = vkpt({"pile.obj", "--frames", "1", "--size", "8x8", "--background", kWhite,
                                "--stats", "s.json", "-o", "x.exr"},
                               {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 5) << r.err;
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  EXPECT_NE(r.errors().front().find("cut traversals"), std::string::npos);
  EXPECT_NE(r.out.find("FAULTS: "), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("written: x.exr"), std::string::npos) << r.out;
  const auto stats = folder.json("s.json");
  EXPECT_EQ(stats["stop"], "fault");
  EXPECT_GT(stats["faults"]["cutTraversal"], 0);
  EXPECT_EQ(readImage(folder / "x.exr").width, 8);
}

} // namespace
} // namespace vkpt::test
