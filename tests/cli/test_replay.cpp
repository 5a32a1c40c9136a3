// One path again: by hand, and by the line that a run with faults prints.

#include "cli/command.h"
#include "cli/small_scenes.h"
#include "film/image.h"

#include <gtest/gtest.h>

#include <sstream>

namespace vkpt::test {
namespace {

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

/// What stands behind `text` in its line; empty where it is not found.
std::string behind(const std::string& all, const std::string& text) {
  const auto at = all.find(text);
  return at == std::string::npos ? "" : all.substr(at + text.size(), all.find('\n', at) - at - text.size());
}

TEST(Replay, SamplesOfAPixelAddUpToIt) {
  const WorkFolder folder;
  const std::vector<std::string> common{"cornell-spheres", "--size", "16x16", "--seed", "3"};
  auto render = common;
  render.insert(render.end(), {"--frames", "4", "-o", "x.pfm"});
  ASSERT_EQ(vkpt(render, {folder.path(), {}}).exitCode, 0);
  const Image image = readImage(folder / "x.pfm");
  double sum = 0.0;
  for (const char* sample : {"0", "1", "2", "3"}) {
    auto replay = common;
    replay.insert(replay.end(), {"--pixel", "11,12", "--sample", sample});
    const CommandResult r = vkpt(replay, {folder.path(), {}, false});
    ASSERT_EQ(r.exitCode, 0) << r.err;
    EXPECT_NE(r.out.find("float64: "), std::string::npos);
    EXPECT_NE(r.out.find("bounce 0 from "), std::string::npos);
    const std::string figures = behind(r.out, "float32: ");
    sum += std::stod(behind(figures + "\n", "value ")) / 4.0;
  }
  EXPECT_NEAR(sum, static_cast<double>(image.channels[0].values[12 * 16 + 11]), 2e-5 * sum);
}

/// Emission that overflows in float after a few reflections, and does not in double.
TEST(Replay, IsOfferedForTheFirstFault) {
  const WorkFolder folder;
  folder.write("box.mtl", "newmtl hot\nillum 1\nKd 1e12 1e12 1e12\nKe 1e12 1e12 1e12\n");
  folder.write("box.obj",
               "mtllib box.mtl\nusemtl hot\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 .1\nv 1 0 .1\n"
               "v 1 1 .1\nv 0 1 .1\nf 1 2 3 4\nf 8 7 6 5\n");
  const CommandResult r = vkpt({"box.obj", "--frames", "2", "--size", "8x8", "--look-at", ".5,.5,.05,.5,.5,0",
                                "--up", "1,0,0", "--max-bounces", "9", "--stats", "s.json"},
                               {folder.path(), {}});
  ASSERT_EQ(r.exitCode, 5) << r.err << r.out;
  const auto records = folder.json("s.json")["faultRecords"];
  ASSERT_FALSE(records.empty());
  EXPECT_LE(records.size(), 64U);
  EXPECT_EQ(records[0]["cause"], "nonFinite");
  auto command = wordsOf(behind(r.out, "vertex by vertex: "));
  ASSERT_GT(command.size(), 4U) << r.out;
  EXPECT_EQ(command.front(), "vkpt");
  command.erase(command.begin());
  const CommandResult again = vkpt(command, {folder.path(), {}, false});
  EXPECT_EQ(again.exitCode, 0) << again.err;
  const auto isFinite = [](const std::string& line) {
    return line.find("inf") == std::string::npos && line.find("nan") == std::string::npos;
  };
  EXPECT_FALSE(isFinite(behind(again.out, "float32: "))) << again.out;
  EXPECT_TRUE(isFinite(behind(again.out, "float64: "))) << again.out;
}

TEST(Replay, RefusesWhatIsNoPixel) {
  const WorkFolder folder;
  EXPECT_EQ(vkpt({"--size", "8x8", "--pixel", "8,0"}, {folder.path(), {}, false}).exitCode, 1);
  EXPECT_EQ(vkpt({"--pixel", "1"}, {folder.path(), {}, false}).exitCode, 1);
  EXPECT_EQ(vkpt({"--pixel", "1.5,2"}, {folder.path(), {}, false}).exitCode, 1);
  EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace vkpt::test
