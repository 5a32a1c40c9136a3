// Compiled pipelines on disk: found again, and never trusted.

#include "cli/command.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vkpt::test {
namespace {

class PipelineCache : public testing::Test {
protected:
  /// Renders with `home` as the folder of caches; returns what the statistics say.
  nlohmann::json render(const std::string& home, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"cornell", "--size", "8x8", "--frames", "1", "--stats", "s.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandResult r = vkpt(arguments, {m_folder.path(), {{"XDG_CACHE_HOME", home}}});
    EXPECT_EQ(r.exitCode, 0) << r.err;
    EXPECT_TRUE(r.warnings().empty()) << r.err;
    return m_folder.json("s.json");
  }
  [[nodiscard]] std::string cache() const { return (m_folder / "cache").string(); }
  /// Relative to the test's folder, sorted.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(m_folder / "cache/vkpt"))
      names.push_back("cache/vkpt/" + entry.path().filename().string());
    std::ranges::sort(names);
    return names;
  }

  WorkFolder m_folder;
};

TEST_F(PipelineCache, HoldsOneFileForEachKernelAndSetOfEffects) {
  const auto mean = render(cache())["mean"];
  const auto first = files();
  EXPECT_EQ(first.size(), 2U) << "path and commit";
  EXPECT_EQ(render(cache())["mean"], mean);
  EXPECT_EQ(files(), first);
  render(cache(), {"--effects", "all"});
  EXPECT_EQ(files().size(), 4U);
}

TEST_F(PipelineCache, IgnoresAndReplacesWhatIsNotItsOwn) {
  const auto mean = render(cache())["mean"];
  const auto names = files();
  ASSERT_EQ(names.size(), 2U);
  const std::string good = m_folder.read(names[0]);
  std::string flipped = good;
  flipped.back() = static_cast<char>(flipped.back() ^ 1);
  const std::vector<std::string> wrong{"",
                                       "x",
                                       good.substr(0, good.size() - 1),
                                       good + "x",
                                       flipped,
                                       m_folder.read(names[1]),
                                       std::string(1 << 20, '\xff')};
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    m_folder.write(names[0], wrong[i]);
    EXPECT_EQ(render(cache())["mean"], mean) << i;
    EXPECT_EQ(m_folder.read(names[0]), good) << i;
  }
  EXPECT_EQ(files(), names) << "nothing else is left behind";
}

TEST_F(PipelineCache, IsDoneWithoutWhereItCannotBeWritten) {
  m_folder.write("file", "");
  for (const std::string& home :
       {(m_folder / "file").string(), std::string("/proc/none"), std::string("relative")})
    render(home, {"--quiet"});
  EXPECT_FALSE(fs::exists(m_folder / "relative/vkpt")); // drivers may put a cache of their own beside it
  EXPECT_EQ(m_folder.read("file"), "");
}

} // namespace
} // namespace vkpt::test
