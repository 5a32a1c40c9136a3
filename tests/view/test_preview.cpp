// The preview on a real screen, against the headless command.

#include "film/image.h"
#include "view/preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>
#include <sstream>
#include <thread>

namespace vkpt::test {
namespace {

const std::vector<std::string> kScene{"cornell", "--size", "240x180"};
const std::string kName = "CornellBox+CornellBlocks"; // by which it saves
/// With paths from the lights, whose sums the window adds.
const std::vector<std::string> kSpheres{"cornell-spheres", "--size", "240x180"};
const std::string kSpheresName = "CornellBox+CornellLeftSphere+CornellRightSphere";

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Words of a line.
std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// The options that key `c` prints.
std::string printedCamera(Preview& preview) {
  const std::size_t before = preview.output().size();
  preview.press("c");
  for (int i = 0; i < 100; ++i) {
    const std::string out = preview.output();
    const std::size_t at = out.find("--look-at", before);
    const std::size_t end = at == std::string::npos ? at : out.find('\n', at);
    if (end != std::string::npos)
      return out.substr(at, end - at);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  ADD_FAILURE() << "no camera was printed";
  return {};
}

struct View {
  std::array<double, 3> eye{};
  std::array<double, 3> target{};
};
View printedView(Preview& preview) {
  std::string list = words(printedCamera(preview)).at(1);
  std::ranges::replace(list, ',', ' ');
  std::istringstream stream(list);
  View view;
  for (double& x : view.eye)
    stream >> x;
  for (double& x : view.target)
    stream >> x;
  EXPECT_TRUE(stream) << list;
  return view;
}

class PreviewTest : public testing::Test {
protected:
  static void SetUpTestSuite() { s_screen = new Screen; }
  static void TearDownTestSuite() { delete s_screen; }
  static const Screen& screen() { return *s_screen; }

  /// Renders without a window into `name`.png and .exr.
  void headless(const std::string& name, std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"-o", name + ".png", "-o", name + ".exr"});
    const CommandResult r = vkpt(arguments, {m_folder.path(), {}, true});
    ASSERT_EQ(r.exitCode, 0) << r.err;
  }

  /// The window shows this picture: the same film, by the same formulas in float, where the file's are
  /// double. Rounding to a byte is undecided for a few in 10 000.
  void expectShown(const Preview& preview, const std::string& png) const {
    const Screenshot expected = readPng(m_folder / png);
    const auto different = preview.differences(expected);
    ASSERT_TRUE(different.has_value()) << "the window is not " << png;
    EXPECT_LE(*different, 3 * expected.pixels.size() / 1000) << png;
  }

  void expectSameFilm(const std::string& a, const std::string& b) const {
    const Image first = readImage(m_folder / a);
    const Image second = readImage(m_folder / b);
    ASSERT_EQ(first.channels.size(), second.channels.size());
    for (std::size_t c = 0; c < first.channels.size(); ++c)
      EXPECT_EQ(first.channels[c].values, second.channels[c].values) << first.channels[c].name;
  }

  static void expectSilent(const CommandResult& r) {
    EXPECT_EQ(r.exitCode, 0) << r.err;
    EXPECT_EQ(r.errors(), std::vector<std::string>()) << r.err;
  }

  WorkFolder m_folder;

private:
  static inline Screen* s_screen = nullptr;
};

TEST_F(PreviewTest, ShowsAndSavesTheHeadlessFilm) {
  headless("plain", with(kSpheres, {"--frames", "8"}));
  headless("bright", with(kSpheres, {"--frames", "8", "--exposure", "0.5", "--tonemap", "aces"}));
  Preview preview(screen(), m_folder, with(kSpheres, {"--frames", "8"}));
  EXPECT_EQ(preview.await("rests")["frames"], 8);
  preview.press("h");
  expectShown(preview, "plain.png");
  preview.press("b");
  const auto saved = preview.await("saved");
  EXPECT_EQ(saved["files"], nlohmann::json({kSpheresName + "-1.png", kSpheresName + "-1.exr"}));
  expectSameFilm("plain.exr", kSpheresName + "-1.exr");
  EXPECT_EQ(readPng(m_folder / "plain.png").pixels, readPng(m_folder / (kSpheresName + "-1.png")).pixels);
  const std::size_t begun = preview.events("begun").size();
  preview.press("plus plus asterisk");
  preview.press("ctrl+s");
  preview.await("saved");
  EXPECT_EQ(readPng(m_folder / "bright.png").pixels, readPng(m_folder / (kSpheresName + "-2.png")).pixels);
  expectShown(preview, "bright.png");
  EXPECT_EQ(preview.events("begun").size(), begun) << "exposure and tonemap leave the film alone";
  expectSilent(preview.quit());
}

TEST_F(PreviewTest, OrbitsAndPrintsTheCamera) {
  // The horizontal field of view comes back as it is, so the camera is the same to the last bit.
  const std::vector<std::string> scene = with(kScene, {"--frames", "8", "--fov", "60"});
  headless("before", scene);
  Preview preview(screen(), m_folder, scene);
  preview.await("rests");
  preview.press("h");
  expectShown(preview, "before.png"); // without the panel, which takes the mouse where it lies
  const View before = printedView(preview);
  screen().user("mousemove 120 90 mousedown 1 mousemove 140 96 mousemove 170 100 mouseup 1");
  const auto coarse = preview.await("begun");
  EXPECT_GT(coarse["coarseness"], 1) << "while the camera moves";
  const auto fine = preview.await("rests");
  EXPECT_EQ(fine["frames"], 8);
  EXPECT_EQ(preview.events("begun").back()["coarseness"], 1);
  const View after = printedView(preview);
  double moved = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(after.target[i], before.target[i], 1e-4) << "the centre stays";
    moved += std::abs(after.eye[i] - before.eye[i]);
  }
  EXPECT_GT(moved, 1.0);
  headless("orbited", with(with(kScene, {"--frames", "8"}), words(printedCamera(preview))));
  EXPECT_NE(readPng(m_folder / "orbited.png").pixels, readPng(m_folder / "before.png").pixels);
  expectShown(preview, "orbited.png");
  expectSilent(preview.quit());
}

TEST_F(PreviewTest, FollowsTheWindowsSize) {
  headless("larger", {"cornell", "--size", "313x201", "--frames", "8"});
  Preview preview(screen(), m_folder, with(kScene, {"--frames", "8"}));
  preview.await("rests");
  preview.press("h");
  screen().user("search --name vkpt windowsize 313 201");
  EXPECT_EQ(preview.await("resized")["size"], nlohmann::json({313, 201}));
  preview.await("rests");
  expectShown(preview, "larger.png");
  screen().user("search --name vkpt windowsize 1 1"); // as small as it gets
  EXPECT_EQ(preview.await("resized")["size"], nlohmann::json({1, 1}));
  screen().user("search --name vkpt windowunmap --sync");
  screen().user("search --name vkpt windowmap --sync");
  screen().user("search --name vkpt windowsize 240 180");
  EXPECT_EQ(preview.await("resized")["size"], nlohmann::json({240, 180}));
  preview.await("rests");
  screen().user("search --name vkpt windowfocus");
  expectSilent(preview.quit());
}

TEST_F(PreviewTest, KeysChooseTheShader) {
  headless("direct", with(kScene, {"--frames", "8", "--max-bounces", "1"}));
  headless("paths", with(kScene, {"--frames", "8"}));
  Preview preview(screen(), m_folder, with(kScene, {"--frames", "8"}));
  preview.await("rests");
  preview.press("h");
  preview.press("r");
  EXPECT_EQ(preview.await("begun")["shader"], "direct light");
  preview.await("rests");
  expectShown(preview, "direct.png");
  preview.press("2");
  EXPECT_EQ(preview.await("begun")["shader"], "normals");
  preview.await("rests");
  preview.press("0");
  EXPECT_EQ(preview.await("begun")["shader"], "base colour");
  preview.await("rests");
  preview.press("t");
  EXPECT_EQ(preview.await("begun")["shader"], "path tracing");
  preview.await("rests");
  expectShown(preview, "paths.png");
  expectSilent(preview.quit());
}

/// A square in the plane z = 0 of a known colour, seen from the front.
TEST_F(PreviewTest, BaseColourAndNormalsOfAKnownSquare) {
  m_folder.write("square.mtl", "newmtl paint\nKd 0.5 0.25 0\nillum 1\n");
  m_folder.write("square.obj",
                 "mtllib square.mtl\nusemtl paint\nv -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n");
  Preview preview(screen(), m_folder,
                  {"square.obj", "--size", "64x64", "--background", "1,1,1", "--look-at", "0,0,3,0,0,0",
                   "--fov", "40", "--frames", "2", "--tonemap", "none"});
  preview.await("rests");
  preview.press("h");
  preview.press("0");
  preview.await("rests");
  const auto filled = [](int r, int g, int b) {
    return Screenshot{64, 64, std::vector<std::array<int, 3>>(64 * 64, {r, g, b})};
  };
  EXPECT_EQ(preview.differences(filled(128, 64, 0)), std::size_t{0});
  preview.press("2");
  preview.await("rests");
  EXPECT_EQ(preview.differences(filled(128, 128, 255)), std::size_t{0});
  // The centre of the orbit is the point under the mouse, and a pixel says what it is made of.
  preview.press("3");
  preview.await("rests");
  screen().user("mousemove 32 32 click 1");
  const auto pivot = preview.await("pivot")["point"];
  EXPECT_NEAR(pivot[0].get<double>(), 0.0, 0.1); // a pixel is 0.034 wide
  EXPECT_NEAR(pivot[1].get<double>(), 0.0, 0.1);
  EXPECT_NEAR(pivot[2].get<double>(), 0.0, 1e-6);
  screen().user("mousemove 20 40 click 2");
  const auto pixel = preview.await("pixel");
  EXPECT_EQ(pixel["pixel"], nlohmann::json({20, 40}));
  EXPECT_EQ(pixel["samples"], 2);
  // Albedo under a white sky: the radiance is the albedo, all of it after one diffuse event.
  EXPECT_NEAR(pixel["mean"][0].get<double>(), 0.5, 1e-4);
  EXPECT_NEAR(pixel["mean"][1].get<double>(), 0.25, 1e-4);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(pixel["kinds"][k][0].get<double>(), k == 1 ? 0.5 : 0.0, 1e-4) << "kind " << k;
  expectSilent(preview.quit());
}

/// From far away: F goes to where the whole box is seen, flight goes straight ahead, Home is where it began.
TEST_F(PreviewTest, FramesFliesAndGoesHome) {
  Preview preview(screen(), m_folder,
                  with(kScene, {"--frames", "4", "--look-at", "40,3,90,40,3,0", "--fov", "40"}));
  preview.await("rests");
  preview.press("h");
  preview.press("f");
  preview.await("rests");
  const View framed = printedView(preview);
  EXPECT_LT(framed.eye[2], 60.0) << "nearer";
  EXPECT_LT(std::abs(framed.target[0]), 10.0) << "the box, whose middle is at 0";
  screen().user("mousemove 120 90 mousedown 3 keydown w sleep 0.5 keyup w mouseup 3");
  preview.await("rests");
  const View flown = printedView(preview);
  double along = 0.0, across = 0.0, ahead = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    ahead += (framed.target[i] - framed.eye[i]) * (framed.target[i] - framed.eye[i]);
  for (std::size_t i = 0; i < 3; ++i)
    along += (flown.eye[i] - framed.eye[i]) * (framed.target[i] - framed.eye[i]) / std::sqrt(ahead);
  for (std::size_t i = 0; i < 3; ++i) {
    const double step = flown.eye[i] - framed.eye[i];
    across += std::pow(step - along * (framed.target[i] - framed.eye[i]) / std::sqrt(ahead), 2.0);
  }
  EXPECT_GT(along, 0.1);
  EXPECT_LT(std::sqrt(across), 1e-3 * along);
  preview.press("Home");
  preview.await("rests");
  const View home = printedView(preview);
  EXPECT_NEAR(home.eye[0], 40.0, 1e-9);
  EXPECT_NEAR(home.eye[2], 90.0, 1e-9);
  expectSilent(preview.quit());
}

TEST_F(PreviewTest, PausesAndGoesOnWhereItWas) {
  headless("whole", with(kScene, {"--frames", "64"}));
  Preview preview(screen(), m_folder, with(kScene, {"--frames", "64"}));
  preview.await("first picture");
  preview.press("h");
  preview.press("p");
  const auto paused = preview.await("rests");
  EXPECT_EQ(paused["reason"], "user");
  EXPECT_LT(paused["frames"], 64);
  preview.press("p");
  EXPECT_EQ(preview.await("goes on")["frames"], paused["frames"]);
  EXPECT_EQ(preview.await("rests")["frames"], 64);
  expectShown(preview, "whole.png");
  expectSilent(preview.quit());
}

TEST_F(PreviewTest, ClosesByItselfAndWritesStats) {
  Preview preview(screen(), m_folder, with(kScene, {"--frames", "20", "--close", "--stats", "run.json"}));
  expectSilent(preview.wait());
  const auto stats = m_folder.json("run.json");
  EXPECT_EQ(stats["frames"], 20);
  EXPECT_EQ(stats["stop"], "frames");
  EXPECT_EQ(stats["width"], 240);
}

TEST_F(PreviewTest, SavesTheFilmWhenTheDeviceIsLost) {
  headless("until", with(kScene, {"--frames", "16"}));
  CommandSettings settings{m_folder.path(), {}, false};
  settings.environment = {{"DISPLAY", screen().display()},
                          {"VK_LAYER_PATH", VKPT_LAYER_FOLDER},
                          {"VK_INSTANCE_LAYERS", "VK_LAYER_VKPT_losing"},
                          {"VKPT_LOSE_AFTER", "3000"}};
  // Looked at once there are 16 frames; a unit of work is one tile's frame.
  const CommandResult r =
      vkpt(with(with({"view"}, kScene), {"--tile-blocks", "64", "--batch", "1"}), settings);
  EXPECT_EQ(r.exitCode, 3) << r.err;
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  EXPECT_NE(r.errors()[0].find("DeviceLost"), std::string::npos) << r.err;
  ASSERT_FALSE(r.warnings().empty());
  EXPECT_NE(r.warnings()[0].find(kName + "-1.png"), std::string::npos);
  const Image saved = readImage(m_folder / (kName + "-1.exr"));
  const Image until = readImage(m_folder / "until.exr");
  double difference = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < saved.pixelCount(); ++i) {
    difference += std::abs(saved.channels[0].values[i] - until.channels[0].values[i]);
    mean += until.channels[0].values[i];
  }
  EXPECT_LT(difference, 0.5 * mean) << "the same picture, with more samples";
}

TEST(PreviewWithoutScreen, NamesTheHeadlessWay) {
  const WorkFolder folder;
  CommandSettings settings;
  settings.folder = folder.path();
  settings.environment["DISPLAY"] = "";
  settings.environment["WAYLAND_DISPLAY"] = "";
  const CommandResult r = vkpt({"view", "cornell"}, settings);
  EXPECT_EQ(r.exitCode, 3);
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  EXPECT_NE(r.errors()[0].find("display"), std::string::npos);
  EXPECT_NE(r.errors()[0].find("vkpt, without view"), std::string::npos);
  EXPECT_TRUE(r.otherLines().empty()) << r.err;
}

} // namespace
} // namespace vkpt::test
