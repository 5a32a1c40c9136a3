// When a run stops, and that it says so.

#include "cli/command.h"
#include "film/image.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace vkpt::test {
namespace {

using nlohmann::json;

class Stop : public testing::TestWithParam<int> {};

TEST_P(Stop, AfterFrames) {
  const WorkFolder folder;
  const int frames = GetParam();
  const CommandResult r =
      vkpt({"--frames", std::to_string(frames), "--size", "40x24", "--stats", "s.json"}, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  const json s = folder.json("s.json");
  EXPECT_EQ(s["frames"], frames);
  EXPECT_EQ(s["samples"], 40 * 24 * frames);
  EXPECT_EQ(s["stop"], "frames");
}
INSTANTIATE_TEST_SUITE_P(Frames, Stop, testing::Values(1, 3, 16, 17, 50), testing::PrintToStringParamName());

TEST(Stop, AfterATime) {
  constexpr double kLimit = 2.0;
  const WorkFolder folder;
  const CommandResult r = vkpt({"--time", "2", "--stats", "s.json"}, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  const json s = folder.json("s.json");
  EXPECT_EQ(s["stop"], "time");
  const double rendering = s["seconds"]["render"];
  tell("--time 2 over by", rendering - kLimit, "s");
  EXPECT_GE(rendering, kLimit);
  EXPECT_LT(rendering, kLimit + 2.0); // the machine may be busy; the figure above is the one to look at
  EXPECT_NEAR(s["frames"].get<double>() * s["width"].get<double>() * s["height"].get<double>(),
              s["samples"].get<double>(), 0.01 * s["samples"].get<double>());
}

TEST(Stop, AtAnError) {
  const WorkFolder folder;
  const CommandResult r = vkpt(
      {"--target-error", "0.3", "--size", "64x64", "--time", "60", "--stats", "s.json"}, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  const json s = folder.json("s.json");
  EXPECT_EQ(s["stop"], "error");
  EXPECT_LE(s["error"]["relativeUpper95"], 0.3);
  EXPECT_LT(s["error"]["relative"], s["error"]["relativeUpper95"]);
  EXPECT_NE(r.out.find("stopped by: error"), std::string::npos) << r.out;
}

TEST(Stop, AtTheFirstRuleThatIsMet) {
  const WorkFolder folder;
  const CommandResult r =
      vkpt({"--frames", "2", "--time", "100", "--target-error", "1e-9", "--size", "8x8", "--stats", "s.json"},
           {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_EQ(folder.json("s.json")["stop"], "frames");
}

TEST(Stop, SaysWhatHalfTheErrorWouldCost) {
  const WorkFolder folder;
  const CommandResult measured = vkpt({"--frames", "256", "--size", "48x48"}, {folder.path(), {}});
  EXPECT_NE(measured.out.find("half of it would take another "), std::string::npos) << measured.out;
  EXPECT_NE(measured.out.find("(measured: "), std::string::npos) << measured.out;
  const CommandResult guessed = vkpt({"--frames", "8", "--size", "32x32"}, {folder.path(), {}});
  EXPECT_NE(guessed.out.find("fewer than 3 looks"), std::string::npos) << guessed.out;
  const CommandResult unknown = vkpt({"--frames", "1", "--size", "32x32"}, {folder.path(), {}});
  EXPECT_EQ(unknown.out.find("half of it"), std::string::npos) << unknown.out;
}

TEST(Stop, SaysWhenATargetOutOfReachWouldBeReached) {
  const WorkFolder folder;
  const CommandResult missed =
      vkpt({"--frames", "64", "--target-error", "0.0001", "--size", "32x32"}, {folder.path(), {}});
  EXPECT_EQ(missed.exitCode, 0) << missed.err;
  EXPECT_NE(missed.out.find("the target, 0.01 %, was not reached; that would take another "),
            std::string::npos)
      << missed.out;
  EXPECT_NE(missed.out.find("an extrapolation over "), std::string::npos) << missed.out;
  const CommandResult met = vkpt({"--target-error", "0.5", "--size", "32x32"}, {folder.path(), {}});
  EXPECT_EQ(met.out.find("the target"), std::string::npos) << met.out;
}

void sleepSeconds(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// The first line of --verbose comes when signals are already looked after.
constexpr const char* kUnderWay = "vkpt: debug: ";
constexpr double kPatience = 60.0;

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, WritesWhatIsFinished) {
  const WorkFolder folder;
  RunningCommand command(
      {"--time", "30", "--size", "256x256", "-o", "x.exr", "--stats", "s.json", "--verbose"},
      {folder.path(), {}});
  ASSERT_TRUE(command.waitForError(kUnderWay, kPatience));
  sleepSeconds(1.5);
  command.signal(GetParam());
  const auto asked = std::chrono::steady_clock::now();
  const CommandResult r = command.wait();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - asked;
  tell("from the signal to the end", took.count(), "s");
  EXPECT_EQ(r.exitCode, 75) << r.err;
  EXPECT_LT(took.count(), 2.0);
  const json s = folder.json("s.json");
  EXPECT_EQ(s["stop"], "user");
  EXPECT_GT(s["samples"], 0);
  EXPECT_EQ(readImage(folder / "x.exr").width, 256);
  EXPECT_NE(r.out.find("stopped by: user"), std::string::npos) << r.out;
  EXPECT_NE(r.out.find("written: x.exr"), std::string::npos) << r.out;
}
INSTANTIATE_TEST_SUITE_P(Signal, Interrupt, testing::Values(SIGINT, SIGTERM),
                         [](const auto& test) { return test.param == SIGINT ? "Sigint" : "Sigterm"; });

TEST(Interrupt, TwiceKillsAndTheOldImageStays) {
  const WorkFolder folder;
  folder.write("x.png", "yesterday's image");
  // A unit of work of 16 M samples, seconds long, so that the second signal finds it unfinished.
  RunningCommand command(
      {"--time", "30", "--size", "1024x1024", "--tile-blocks", "16384", "-o", "x.png", "--verbose"},
      {folder.path(), {}});
  ASSERT_TRUE(command.waitForError(kUnderWay, kPatience));
  sleepSeconds(0.5);
  command.signal(SIGINT);
  sleepSeconds(0.3);
  command.signal(SIGINT);
  const CommandResult r = command.wait();
  EXPECT_EQ(r.signal, SIGINT) << "exit code " << r.exitCode;
  EXPECT_EQ(folder.read("x.png"), "yesterday's image");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"x.png"});
}

} // namespace
} // namespace vkpt::test
