// vkpt study at a size of seconds: the report, its figures, and what is refused.

#include "cli/browser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

namespace vkpt::test {
namespace {

using nlohmann::json;

CommandResult study(const WorkFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "study");
  return vkpt(arguments, {folder.path(), {}});
}

std::vector<std::string> namesOf(const json& results) {
  std::vector<std::string> names;
  for (const auto& setting : results["settings"])
    names.push_back(setting["name"]);
  return names;
}

TEST(Study, ComparesSettingsInAReportThatStandsAlone) {
  const WorkFolder folder;
  const CommandResult r = study(folder, {"cornell", "--size", "24x24", "--frames", "24", "--seeds", "2",
                                         "--seed", "7", "--vary", "light=nee,bsdf", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const json results = folder.json("out/results.json");
  EXPECT_EQ(namesOf(results), (std::vector<std::string>{"light=nee", "light=bsdf"}));
  EXPECT_EQ(results["equalFrames"], 24);
  EXPECT_EQ(results["stop"], "limits");
  EXPECT_EQ(results["reference"]["frames"], 240);
  EXPECT_GT(results["reference"]["noiseRelMse"], 0.0);
  for (const auto& setting : results["settings"]) {
    ASSERT_EQ(setting["runs"].size(), 2U);
    EXPECT_EQ(setting["runs"][1]["seed"], 8);
    std::vector<int> frames;
    for (const auto& point : setting["runs"][0]["points"])
      frames.push_back(point["frames"]);
    EXPECT_EQ(frames, (std::vector<int>{1, 2, 4, 8, 16, 24}));
    EXPECT_NE(setting["runs"][0]["points"][0]["mse"], setting["runs"][1]["points"][0]["mse"]);
  }
  // Light sampling is better by far in this box.
  EXPECT_LT(results["settings"][0]["errorAtEqualFrames"]["median"].get<double>(),
            0.5 * results["settings"][1]["errorAtEqualFrames"]["median"].get<double>());

  const std::string csv = folder.read("out/results.csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 2 * 2 * 6);
  const std::string html = folder.read("out/report.html");
  EXPECT_TRUE(contains(html, "light=bsdf"));
  EXPECT_TRUE(contains(html, "data:image/svg+xml;base64,"));
  EXPECT_TRUE(contains(html, "type=range"));
  EXPECT_FALSE(contains(html, "http")); // nothing from elsewhere
  for (const char* file : {"error-time.svg", "error-time.png", "error-frames.svg", "error-frames.png",
                           "picture-2.png", "difference-2.png", "reference.png"})
    EXPECT_TRUE(fs::exists(folder / "out" / file)) << file;
  EXPECT_TRUE(contains(r.out, "out/report.html")) << r.out;
}

TEST(Study, ItsReportOpensInABrowser) {
  if (chromium().empty())
    GTEST_SKIP() << "no chromium here";
  const WorkFolder folder;
  const CommandResult r = study(folder, {"cornell", "cornell-spheres", "--size", "24x24", "--frames", "16",
                                         "--seeds", "2", "--vary", "light=nee,bsdf", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const OpenedPage page = openPage(folder / "out/report.html");
  EXPECT_TRUE(page.console.empty()) << page.console.front();
  // of each scene two plots, three pictures, two differences, and the two under the slider
  ASSERT_EQ(page.facts["images"].size(), 2U * 9U) << page.facts;
  std::size_t plots = 0;
  for (const json& image : page.facts["images"]) {
    EXPECT_GT(image["width"], 0) << image;
    EXPECT_GT(image["colours"], 3) << image; // a plot without curves has black, white and grey
    plots += image["alt"] == "error-time" || image["alt"] == "error-frames" ? 1U : 0U;
  }
  EXPECT_EQ(plots, 4U);
  ASSERT_EQ(page.facts["sliders"].size(), 2U);
  for (const json& slider : page.facts["sliders"]) {
    EXPECT_EQ(slider["clip"], "inset(0px 75% 0px 0px)");
    EXPECT_EQ(slider["names"].size(), 3U);
    EXPECT_TRUE(slider["left"].get<bool>() && slider["right"].get<bool>()) << slider;
  }
}

TEST(Study, SeveralScenesEachHaveTheirOwnReference) {
  const WorkFolder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("b.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
  const CommandResult r = study(folder, {"a.obj", "cornell", "b.obj", "--background", "1,1,1", "--size",
                                         "8x8", "--frames", "4", "--seeds", "1", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const json scenes = folder.json("out/results.json")["scenes"];
  ASSERT_EQ(scenes.size(), 2U); // .obj files are one scene
  EXPECT_EQ(scenes[0]["scene"], "a+b");
  EXPECT_NE(scenes[0]["reference"]["mean"], scenes[1]["reference"]["mean"]);
  EXPECT_TRUE(fs::exists(folder / "out/1-a-b/results.csv"));
  EXPECT_TRUE(fs::exists(folder / "out/2-CornellBox-CornellBlocks/results.csv"));
}

TEST(Study, ATargetEndsARunOrSaysWhenItWould) {
  const WorkFolder folder;
  const std::vector<std::string> common{"cornell", "--size", "16x16", "--frames", "512", "--seeds", "1"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), common.begin(), common.end());
    return study(folder, more);
  };
  const CommandResult met = with({"--target-error", "0.6", "-o", "met"});
  ASSERT_EQ(met.exitCode, 0) << met.err;
  const json points = folder.json("met/results.json")["settings"][0]["runs"][0]["points"];
  EXPECT_LT(points.back()["frames"], 512);
  EXPECT_LE(points.back()["relMse"], 0.36);
  EXPECT_GT(points[points.size() - 2]["relMse"], 0.36);
  EXPECT_FALSE(contains(met.out, "was not reached")) << met.out;
  const CommandResult missed = with({"--target-error", "0.0001", "-o", "missed"});
  ASSERT_EQ(missed.exitCode, 0) << missed.err;
  EXPECT_TRUE(contains(missed.out, "the target, 0.01 %, was not reached; it would take more than "))
      << missed.out;
}

TEST(Study, TellsABiasAndTakesValuesWithAnEqualsSign) {
  const WorkFolder folder;
  const CommandResult r = study(folder, {"cornell", "--size", "24x24", "--frames", "32", "--seeds", "2",
                                         "--vary", "roulette=throughput,constant=1.0", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const json results = folder.json("out/results.json");
  ASSERT_EQ(namesOf(results), (std::vector<std::string>{"roulette=throughput", "roulette=constant=1.0"}));
  EXPECT_FALSE(results["settings"][0]["biased"]);
  EXPECT_TRUE(results["settings"][1]["biased"]); // paths of three edges are not all of the light
  EXPECT_LT(results["settings"][1]["energy"]["value"].get<double>(), -0.05);
  EXPECT_TRUE(contains(r.out, "a bias")) << r.out;
  EXPECT_EQ(results["settings"][1]["bias"], json::array({"--roulette constant=1 (--max-bounces 2)"}));
  EXPECT_GT(results["settings"][1]["lastingRelMse"]["value"].get<double>(), 0.0);
  EXPECT_TRUE(contains(folder.read("out/report.html"), "The cost of bias"));
}

TEST(Study, EveryCombinationOfOneKindOfPath) {
  const WorkFolder folder;
  const CommandResult r =
      study(folder, {"cornell-spheres", "--size", "16x16", "--frames", "2", "--seeds", "1", "--class",
                     "caustic", "--vary", "split=0,2", "--vary", "light=nee,mis", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const json results = folder.json("out/results.json");
  EXPECT_EQ(namesOf(results), (std::vector<std::string>{"split=0, light=nee", "split=0, light=mis",
                                                        "split=2, light=nee", "split=2, light=mis"}));
  EXPECT_EQ(results["class"], "caustic");
  EXPECT_LT(results["reference"]["mean"][0].get<double>(), 0.2); // the whole has 0.5
}

TEST(Study, LeavesOutEachPartInTurn) {
  const WorkFolder folder;
  const CommandResult r = study(folder, {"cornell-spheres", "--size", "16x16", "--frames", "16", "--seeds",
                                         "1", "--ablate", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const json results = folder.json("out/results.json");
  const auto energyWithout = [&](const std::string& what) {
    const auto& settings = results["settings"];
    const auto found = std::ranges::find_if(settings, [&](const json& s) { return s["name"] == what; });
    return found == settings.end() ? 0.0 : (*found)["energy"]["value"].get<double>();
  };
  EXPECT_EQ(results["settings"][0]["name"], "whole");
  EXPECT_LT(energyWithout("without direct paths"), -0.1);
  EXPECT_LT(energyWithout("without diffuse"), -0.1);
  EXPECT_LT(energyWithout("without glass"), 0.0);
  EXPECT_TRUE(contains(folder.read("out/report.html"), "What each part costs"));
}

TEST(Study, StopsBeforeAReferenceThatIsNoBetter) {
  const WorkFolder folder;
  ASSERT_EQ(
      vkpt({"cornell", "--size", "24x24", "--frames", "256", "--seed", "99", "-o", "r.exr", "-o", "r.pfm"},
           {folder.path(), {}})
          .exitCode,
      0);
  const CommandResult r =
      study(folder, {"cornell", "--reference", "r.exr", "--frames", "256", "--seeds", "2", "-o", "out"});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const json results = folder.json("out/results.json");
  EXPECT_EQ(results["stop"], "referenceNoise");
  EXPECT_EQ(results["width"], 24); // of the reference
  EXPECT_LT(results["equalFrames"].get<int>(), 256);
  EXPECT_TRUE(contains(r.out, "the reference's own noise")) << r.out;

  const CommandResult blind =
      study(folder, {"cornell", "--reference", "r.pfm", "--frames", "4", "--seeds", "1", "-o", "blind"});
  ASSERT_EQ(blind.exitCode, 0) << blind.err;
  EXPECT_FALSE(folder.json("blind/results.json")["reference"]["noiseKnown"]);
  EXPECT_TRUE(contains(blind.out, "no standard errors")) << blind.out;
}

TEST(Study, AFolderWithFilesIsNotTouchedUnlessForced) {
  const WorkFolder folder;
  fs::create_directory(folder / "out");
  folder.write("out/mine.txt", "mine");
  const std::vector<std::string> arguments{"cornell", "--size", "8x8", "--frames", "2",
                                           "--seeds", "1",      "-o",  "out"};
  const CommandResult refused = study(folder, arguments);
  EXPECT_EQ(refused.exitCode, 1);
  ASSERT_EQ(refused.errors().size(), 1U) << refused.err;
  EXPECT_TRUE(contains(refused.errors().front(), "--force"));
  EXPECT_FALSE(fs::exists(folder / "out" / "report.html"));
  auto forced = arguments;
  forced.emplace_back("--force");
  EXPECT_EQ(study(folder, forced).exitCode, 0);
  EXPECT_TRUE(fs::exists(folder / "out" / "report.html"));
  EXPECT_EQ(folder.read("out/mine.txt"), "mine");
}

TEST(Study, AnInterruptWritesTheReportSoFar) {
  const WorkFolder folder;
  ASSERT_EQ(
      vkpt({"cornell", "--size", "64x64", "--frames", "64", "-o", "r.exr"}, {folder.path(), {}}).exitCode, 0);
  RunningCommand command({"study", "cornell", "--reference", "r.exr", "--time", "30", "--vary",
                          "light=bsdf,nee", "--background", "0.1,0.1,0.1", "-o", "out", "--verbose"},
                         {folder.path(), {}});
  ASSERT_TRUE(command.waitForError("vkpt: debug: ", 60.0));
  std::this_thread::sleep_for(std::chrono::seconds(2));
  command.signal(SIGINT);
  const CommandResult r = command.wait();
  EXPECT_EQ(r.exitCode, static_cast<int>(ExitCode::Interrupted)) << r.err;
  EXPECT_EQ(folder.json("out/results.json")["stop"], "user");
  EXPECT_TRUE(contains(folder.read("out/report.html"), "Interrupted"));
}

class StudyRefuses : public testing::TestWithParam<WrongCall> {};

TEST_P(StudyRefuses, InOneLine) {
  const WorkFolder folder;
  folder.write("file", "");
  folder.write("small.pfm", "PF\n1 1\n-1.0\n............");
  const auto before = folder.names();
  const CommandResult r = study(folder, GetParam().arguments);
  EXPECT_EQ(r.exitCode, static_cast<int>(GetParam().code)) << r.err;
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  for (const char* part : GetParam().says)
    EXPECT_TRUE(contains(r.errors().front(), part)) << part << "\nis not in\n" << r.err;
  EXPECT_EQ(folder.names(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Input, StudyRefuses,
    testing::Values(
        WrongCall{"NoValues", {"--vary", "split"}, ExitCode::Usage, {"--vary 'split'", "OPTION=A,B"}},
        WrongCall{"CannotVary",
                  {"--vary", "size=8x8,16x16"},
                  ExitCode::Usage,
                  {"size=8x8", "light, light-samples"}},
        WrongCall{"BadValue", {"--vary", "split=0,99"}, ExitCode::Usage, {"--split '99'", "0 to 16"}},
        WrongCall{"VariedAndGiven", {"--vary", "split=0,1", "--split", "2"}, ExitCode::Usage, {"--split"}},
        WrongCall{"UnknownOption", {"--varry", "split=0,1"}, ExitCode::Usage, {"--varry"}},
        WrongCall{"UnknownKind", {"--class", "caustics"}, ExitCode::Usage, {"--class 'caustics'", "caustic"}},
        WrongCall{
            "AblateAndVary", {"--ablate", "--vary", "split=0,1"}, ExitCode::Usage, {"--ablate", "--vary"}},
        WrongCall{"OneReferenceForTwoScenes",
                  {"cornell", "cornell-spheres", "--reference", "small.pfm"},
                  ExitCode::Usage,
                  {"--reference", "2"}},
        WrongCall{"Stats", {"--stats", "s.json"}, ExitCode::Usage, {"--stats"}},
        WrongCall{"NoSeeds", {"--seeds", "0"}, ExitCode::Usage, {"--seeds '0'"}},
        WrongCall{"OutputIsAFile", {"-o", "file"}, ExitCode::Usage, {"file", "folder"}},
        WrongCall{"NoSuchReference", {"--reference", "gone.exr"}, ExitCode::Scene, {"gone.exr"}},
        WrongCall{"ReferenceOfAnotherSize",
                  {"--reference", "small.pfm", "--size", "8x8"},
                  ExitCode::Scene,
                  {"small.pfm", "1x1", "8x8"}},
        WrongCall{"NoSuchScene", {"gone.obj"}, ExitCode::Scene, {"gone.obj"}}),
    testing::PrintToStringParamName());

TEST(Study, WithoutGnuplotSaysWhichPackageIsMissing) {
  const WorkFolder folder;
  const CommandResult r = vkpt({"study", "--frames", "1"}, {folder.path(), {{"PATH", "/nonexistent"}}});
  EXPECT_EQ(r.exitCode, 1);
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  EXPECT_TRUE(contains(r.errors().front(), "gnuplot-nox")) << r.err;
  EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace vkpt::test
