// --pilot: what is worth most in a scene is tried before it is rendered.

#include "cli/command.h"
#include "film/image.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace vkpt::test {
namespace {

/// The line that tells of it.
std::string pilotNote(const nlohmann::json& stats) {
  for (const std::string note : stats["notes"]) {
    if (note.starts_with("pilot"))
      return note;
  }
  ADD_FAILURE() << "no word of the pilot";
  return {};
}

std::vector<std::string> chosenOptions(const std::string& note) {
  std::istringstream stream(note.substr(note.find("chosen: ") + std::string("chosen: ").size()));
  return {std::istream_iterator<std::string>(stream), {}};
}

class Pilot : public testing::Test {
protected:
  nlohmann::json render(const std::vector<std::string>& more, const std::string& image) const {
    std::vector<std::string> arguments{"cornell", "--size", "64x64", "--frames", "6",
                                       "--stats", "s.json", "-o",    image};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandResult r = vkpt(arguments, {m_folder.path(), {}});
    EXPECT_EQ(r.exitCode, 0) << r.err;
    return m_folder.json("s.json");
  }
  void expectUsage(const std::vector<std::string>& arguments) const {
    const CommandResult r = vkpt(arguments, {m_folder.path(), {}});
    EXPECT_EQ(r.exitCode, 1) << r.err;
    ASSERT_EQ(r.errors().size(), 1U) << r.err;
    EXPECT_NE(r.err.find("--pilot"), std::string::npos) << r.err;
  }
  WorkFolder m_folder;
};

/// In the box with blocks, where they are worth more than twice as much; and what is rendered then is what
/// these options render.
TEST_F(Pilot, ChoosesSharedPathsWhereTheyPay) {
  const std::string note = pilotNote(render({"--pilot", "0.1"}, "piloted.pfm"));
  std::smatch gain;
  ASSERT_TRUE(std::regex_search(note, gain, std::regex("--path-reuse 64: ([0-9.]+)"))) << note;
  EXPECT_GT(std::stod(gain[1]), 1.2) << note;
  EXPECT_LT(std::stod(gain[1]), 8.0) << note << " (its error alone is 20 times smaller)";
  const std::vector<std::string> chosen = chosenOptions(note);
  ASSERT_GE(chosen.size(), 2U) << note;
  EXPECT_NE(std::ranges::find(chosen, "--path-reuse"), chosen.end()) << note;
  const nlohmann::json stats = render(chosen, "chosen.pfm");
  EXPECT_NE(std::ranges::find(stats["effects"], "pathReuse"), stats["effects"].end());
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_EQ(readImage(m_folder / "piloted.pfm").channels[c].values,
              readImage(m_folder / "chosen.pfm").channels[c].values);
}

TEST_F(Pilot, LeavesOptionsThatAreGiven) {
  const std::string note =
      pilotNote(render({"--path-reuse=1", "--light-selection", "power", "--pilot=0.1"}, "a.pfm"));
  EXPECT_EQ(note, "pilot: nothing to choose in this scene");
}

TEST_F(Pilot, IsForRendersAlone) {
  expectUsage({"cornell", "--pilot", "0"});
  expectUsage({"explain", "cornell", "--pilot", "1"});
  expectUsage({"study", "cornell", "--pilot", "1"});
  expectUsage({"cornell", "--pixel", "1,1", "--pilot", "1"});
}

} // namespace
} // namespace vkpt::test
