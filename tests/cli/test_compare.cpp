// vkpt compare, as a user and a script meet it.

#include "cli/command.h"
#include "film/image.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vkpt::test {
namespace {

CommandSettings in(const WorkFolder& folder) { return {folder.path(), {}, false}; }

/// Two grey pixels.
Image pair(float first, float second) {
  Image image(2, 1, {"R", "G", "B"});
  for (auto& channel : image.channels)
    channel.values = {first, second};
  return image;
}

void write(const WorkFolder& folder, const std::string& name, const Image& image) {
  writeImage(folder / name, image, {0.0, Tonemap::Srgb}, {});
}

class EachFormat : public testing::TestWithParam<const char*> {};

TEST_P(EachFormat, IsComparedInLinearValues) {
  const WorkFolder folder;
  const std::string name = std::string("a") + GetParam();
  write(folder, name, pair(1.0F, 0.0F)); // exact in every format
  write(folder, "b.exr", pair(0.5F, 0.5F));
  const CommandResult r = vkpt({"compare", name, "b.exr", "--json", "d.json"}, in(folder));
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const auto d = folder.json("d.json");
  EXPECT_DOUBLE_EQ(d["mse"], 0.25);
  EXPECT_DOUBLE_EQ(d["rmse"], 0.5);
  EXPECT_NEAR(d["relMse"].get<double>(), 0.25 / (0.25 + 0.005 * 0.005), 1e-12);
  EXPECT_NEAR(d["psnr"].get<double>(), 0.0, 1e-12);
  EXPECT_EQ(d["meanDifference"], nlohmann::json({0.0, 0.0, 0.0}));
  EXPECT_TRUE(d["z"].is_null());
  EXPECT_NE(r.out.find("MSE 0.25"), std::string::npos) << r.out;
}
INSTANTIATE_TEST_SUITE_P(Formats, EachFormat, testing::Values(".exr", ".hdr", ".pfm", ".png"),
                         [](const auto& format) { return std::string(format.param).substr(1); });

TEST(Compare, TwoSeedsOfOneSceneDifferByTheirErrors) {
  const WorkFolder folder;
  for (const char* seed : {"1", "2"}) {
    const CommandResult r =
        vkpt({"--size", "32x32", "--frames", "32", "--seed", seed, "-o", std::string("s") + seed + ".exr"},
             {folder.path(), {}});
    ASSERT_EQ(r.exitCode, 0) << r.err;
  }
  const CommandResult r =
      vkpt({"compare", "s1.exr", "s2.exr", "--json", "d.json", "-o", "d.png", "--max-z", "5"}, in(folder));
  EXPECT_EQ(r.exitCode, 0) << r.err;
  const double z = folder.json("d.json")["z"];
  EXPECT_GT(std::abs(z), 0.0);
  EXPECT_LT(std::abs(z), 5.0); // 6e-7 by chance for a channel, and the seeds are fixed
  const Image picture = readImage(folder / "d.png");
  EXPECT_EQ(picture.width, 32);
  EXPECT_EQ(picture.height, 32);
}

TEST(Compare, PastALimitExitsWithFour) {
  const WorkFolder folder;
  write(folder, "a.pfm", pair(1.0F, 0.0F));
  write(folder, "b.pfm", pair(0.5F, 0.5F));
  struct Case {
    std::vector<std::string> limit;
    bool holds;
  };
  for (const Case& c : {Case{{"--max-mse", "0.25"}, true}, Case{{"--max-mse", "0.2"}, false},
                        Case{{"--max-rmse", "0.51"}, true}, Case{{"--max-rmse", "0.49"}, false},
                        Case{{"--max-rel-mse", "1"}, true}, Case{{"--max-rel-mse", "0.9"}, false}}) {
    std::vector<std::string> arguments{"compare", "a.pfm", "b.pfm", "--quiet"};
    arguments.insert(arguments.end(), c.limit.begin(), c.limit.end());
    const CommandResult r = vkpt(arguments, in(folder));
    EXPECT_EQ(r.exitCode, c.holds ? 0 : 4) << c.limit[0] << " " << c.limit[1] << r.err;
    EXPECT_EQ(r.errors().size(), c.holds ? 0U : 1U) << r.err;
    EXPECT_TRUE(r.out.empty());
    if (!c.holds) {
      EXPECT_NE(r.err.find(c.limit[0]), std::string::npos) << r.err;
    }
  }
}

TEST(Compare, SaysHowManyPixelsWereLeftOut) {
  const WorkFolder folder;
  write(folder, "a.pfm", pair(NAN, 1.0F));
  write(folder, "b.pfm", pair(0.5F, 0.5F));
  const CommandResult r = vkpt({"compare", "a.pfm", "b.pfm", "--json", "d.json"}, in(folder));
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_NE(r.out.find("left out: 1 pixel"), std::string::npos) << r.out;
  EXPECT_EQ(folder.json("d.json")["nonFinitePixels"], 1);
}

class CompareRefuses : public testing::TestWithParam<WrongCall> {};

TEST_P(CompareRefuses, InOneLine) {
  const WorkFolder folder;
  write(folder, "a.pfm", pair(1.0F, 0.0F));
  write(folder, "nan.pfm", pair(NAN, NAN));
  write(folder, "big.exr", Image(3, 5, {"R", "G", "B"}));
  folder.write("broken.exr", "no image");
  const auto before = folder.names();
  std::vector<std::string> arguments{"compare"};
  arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
  const CommandResult r = vkpt(arguments, in(folder));
  EXPECT_EQ(r.exitCode, static_cast<int>(GetParam().code)) << r.err;
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  for (const char* part : GetParam().says)
    EXPECT_NE(r.errors().front().find(part), std::string::npos) << part << "\nis not in\n" << r.err;
  EXPECT_EQ(folder.names(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Input, CompareRefuses,
    testing::Values(
        WrongCall{"NoImage", {}, ExitCode::Usage, {"0 images", "two"}},
        WrongCall{"OneImage", {"a.pfm"}, ExitCode::Usage, {"1 images"}},
        WrongCall{"ThreeImages", {"a.pfm", "a.pfm", "a.pfm"}, ExitCode::Usage, {"3 images"}},
        WrongCall{"NoSuchFile", {"a.pfm", "gone.pfm"}, ExitCode::Scene, {"gone.pfm"}},
        WrongCall{"BrokenFile", {"broken.exr", "a.pfm"}, ExitCode::Scene, {"broken.exr"}},
        WrongCall{"UnknownFormat", {"a.pfm", "x.tiff"}, ExitCode::Scene, {"x.tiff", ".exr"}},
        WrongCall{"OtherSize",
                  {"a.pfm", "big.exr", "--json", "d.json"},
                  ExitCode::Scene,
                  {"2x1", "big.exr", "3x5"}},
        WrongCall{"NothingFinite", {"a.pfm", "nan.pfm"}, ExitCode::Scene, {"no pixel is finite"}},
        WrongCall{
            "ZWithoutErrors", {"a.pfm", "a.pfm", "--max-z", "3"}, ExitCode::Scene, {"--max-z", "stderr"}},
        WrongCall{
            "NegativeLimit", {"a.pfm", "a.pfm", "--max-mse", "-1"}, ExitCode::Usage, {"--max-mse '-1'"}},
        WrongCall{"NoNumber", {"a.pfm", "a.pfm", "--max-rmse", "x"}, ExitCode::Usage, {"--max-rmse 'x'"}},
        WrongCall{"PictureNoPng", {"a.pfm", "a.pfm", "-o", "d.exr"}, ExitCode::Usage, {"d.exr", ".png"}},
        WrongCall{"NoSuchFolder", {"a.pfm", "a.pfm", "-o", "gone/d.png"}, ExitCode::Usage, {"gone"}},
        WrongCall{"UnknownOption",
                  {"a.pfm", "a.pfm", "--max-rsme", "1"},
                  ExitCode::Usage,
                  {"--max-rsme", "did you mean"}}),
    testing::PrintToStringParamName());

} // namespace
} // namespace vkpt::test
