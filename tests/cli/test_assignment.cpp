// vkpt assignment a|b --quick: everything that the sheets ask for is there, and the page opens.

#include "cli/browser.h"
#include "film/image.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace vkpt::test {
namespace {

using nlohmann::json;

CommandResult assignment(const WorkFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "assignment");
  return vkpt(arguments, {folder.path(), {}});
}

struct Listed {
  std::string name, samples, arguments;
};

std::vector<Listed> list(const std::string& sheet) {
  const WorkFolder folder;
  CommandSettings settings{folder.path(), {}};
  settings.validation = false;
  const CommandResult r = vkpt({"assignment", sheet, "--list"}, settings);
  EXPECT_EQ(r.exitCode, 0) << r.err;
  std::vector<Listed> pictures;
  std::istringstream lines(r.out);
  for (std::string line; std::getline(lines, line);) {
    Listed picture;
    std::istringstream words(line);
    words >> picture.name >> picture.samples >> std::ws;
    std::getline(words, picture.arguments);
    pictures.push_back(picture);
  }
  return pictures;
}

class Assignment : public testing::TestWithParam<const char*> {};

TEST_P(Assignment, MakesEveryDeliverable) {
  const std::string sheet = GetParam();
  const WorkFolder folder;
  const CommandResult r = assignment(folder, {sheet, "--quick", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const std::string html = folder.read("out/index.html");
  for (const Listed& picture : list(sheet)) {
    const Image image = readImage(folder / ("out/" + picture.name + ".exr"));
    EXPECT_NE(image.find("stderr.R"), nullptr) << picture.name;
    EXPECT_TRUE(fs::exists(folder / ("out/" + picture.name + ".png"))) << picture.name;
    EXPECT_TRUE(contains(html, "<code>vkpt " + picture.arguments + "</code>")) << picture.arguments;
    EXPECT_TRUE(contains(r.out, picture.name)) << r.out;
  }
  EXPECT_FALSE(contains(html, "http://")); // nothing from elsewhere
  EXPECT_FALSE(contains(html, "https://"));
  EXPECT_FALSE(contains(html, "Not all of it"));
  if (chromium().empty())
    GTEST_SKIP() << "no chromium here";
  const OpenedPage page = openPage(folder / "out/index.html");
  EXPECT_TRUE(page.console.empty()) << page.console.front();
  const std::size_t experiments = sheet == "a" ? 2 : 1;
  ASSERT_EQ(page.facts["sliders"].size(), experiments);
  EXPECT_EQ(page.facts["sliders"][0]["names"].size(), 5U); // four settings and the reference
  // the pictures; of each experiment two plots, nine pictures and the two under the slider
  std::size_t annotated = 0;
  for (const json& image : page.facts["images"]) {
    EXPECT_GT(image["width"], 0) << image;
    EXPECT_GT(image["colours"], 1) << image;
    annotated += image["alt"] == "secondary caustics, numbered" ? 1U : 0U;
  }
  EXPECT_EQ(page.facts["images"].size(), list(sheet).size() + annotated + experiments * (2 + 9 + 2));
  EXPECT_EQ(annotated, sheet == "a" ? 2U : 0U);
}

INSTANTIATE_TEST_SUITE_P(Sheet, Assignment, testing::Values("a", "b"),
                         [](const auto& test) { return std::string(test.param) == "a" ? "A" : "B"; });

TEST(AssignmentPage, AnswersTheQuestionsWithThisRunsFigures) {
  const WorkFolder folder;
  const CommandResult r =
      assignment(folder, {"b", "--quick", "--only", "b-cbox-q1.0,b-cbox-q0.1,b-own-time-q0.4", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const std::string html = folder.read("out/index.html");
  EXPECT_TRUE(contains(html, "Not all of it"));
  for (const char* words :
       {"light area sampling has already taken", "divided by the\nprobability",
        "Multiple importance sampling", "At 4 samples per pixel q = 0.7, 0.4 and 0.1 took"})
    EXPECT_TRUE(contains(html, words)) << words;
  // q = 1 stops after two bounces: less light than q = 0.1, whose mean the table has
  const auto mean = [&](const char* name) {
    const Image image = readImage(folder / (std::string("out/") + name + ".exr"));
    double sum = 0.0;
    for (const float v : image.channels[0].values)
      sum += v;
    return sum / static_cast<double>(image.pixelCount());
  };
  EXPECT_LT(mean("b-cbox-q1.0"), 0.9 * mean("b-cbox-q0.1"));
  EXPECT_TRUE(fs::exists(folder / "out/scene/q-scene.xml"));
  CommandSettings settings{folder.path(), {}};
  EXPECT_EQ(vkpt({"out/scene/q-scene.xml", "--frames", "1", "--size", "24x8"}, settings).exitCode, 0);
}

TEST(AssignmentPage, AnInterruptWritesWhatIsFinished) {
  const WorkFolder folder;
  RunningCommand command({"assignment", "a", "--quality", "0.05", "-o", "out"}, {folder.path(), {}});
  for (int i = 0; i < 2000 && !fs::exists(folder / "out/a-blocks.exr"); ++i)
    ::usleep(50000);
  command.signal(SIGINT);
  const CommandResult r = command.wait();
  EXPECT_EQ(r.exitCode, static_cast<int>(ExitCode::Interrupted)) << r.err;
  EXPECT_TRUE(contains(folder.read("out/index.html"), "Not all of it"));
  EXPECT_FALSE(fs::exists(folder / "out/a-split-4.png"));
}

TEST(AssignmentPage, ListIsTheReadmesTable) {
  std::ostringstream text;
  text << std::ifstream(std::string(VKPT_SOURCE_DIR) + "/README.md").rdbuf();
  for (const char* sheet : {"a", "b"}) {
    const auto pictures = list(sheet);
    EXPECT_GE(pictures.size(), 8U);
    for (const Listed& picture : pictures) {
      EXPECT_TRUE(contains(text.str(), "| `" + picture.name + "` | `" + picture.arguments + "` |"))
          << picture.name;
      EXPECT_TRUE(
          fs::exists(fs::path(VKPT_SOURCE_DIR) / "assets/gallery" / fmt::format("{}.png", picture.name)));
    }
  }
}

struct WrongAssignment {
  const char* name;
  std::vector<std::string> arguments;
  std::vector<const char*> says;
};

class AssignmentRefuses : public testing::TestWithParam<WrongAssignment> {};

TEST_P(AssignmentRefuses, InOneLine) {
  const WorkFolder folder;
  folder.write("file", "");
  fs::create_directory(folder / "full");
  folder.write("full/mine.txt", "mine");
  const auto before = folder.names();
  const CommandResult r = assignment(folder, GetParam().arguments);
  EXPECT_EQ(r.exitCode, static_cast<int>(ExitCode::Usage)) << r.err;
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  for (const char* part : GetParam().says)
    EXPECT_TRUE(contains(r.errors().front(), part)) << part << "\nis not in\n" << r.err;
  EXPECT_EQ(folder.names(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Input, AssignmentRefuses,
    testing::Values(
        WrongAssignment{"NoSheet", {"-o", "out"}, {"vkpt assignment a"}},
        WrongAssignment{"NoSuchSheet", {"c", "-o", "out"}, {"'c'", "a or b"}},
        WrongAssignment{"FolderWithFiles", {"a", "--quick", "-o", "full"}, {"full", "--force"}},
        WrongAssignment{"NoFolder", {"a", "--quick", "-o", "file"}, {"file", "folder"}},
        WrongAssignment{
            "NoSuchPicture", {"a", "--only", "a-nothing", "-o", "out"}, {"a-nothing", "a-blocks"}},
        WrongAssignment{"PictureOfTheOther", {"a", "--only", "b-busts", "-o", "out"}, {"b-busts"}},
        WrongAssignment{"NoQuality", {"a", "--quality", "0", "-o", "out"}, {"--quality '0'"}}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace vkpt::test
