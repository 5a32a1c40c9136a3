// The files that a run leaves: images in every format, and the figures of --stats.

#include "cli/command.h"
#include "film/image.h"

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <cmath>

namespace vkpt::test {
namespace {

using nlohmann::json;

const std::vector<std::string> kSmall{"--frames", "5", "--size", "33x17"};

std::vector<std::string> small(std::vector<std::string> more) {
  more.insert(more.begin(), kSmall.begin(), kSmall.end());
  return more;
}

/// Every promised key of schema 1, with a value of its type (interface.md).
const json kPromised = json::parse(R"({
  "schema": 1, "scene": "", "width": 1, "height": 1, "frames": 1, "stop": "",
  "seconds": {"load": 0.1, "build": 0.1, "compile": 0.1, "render": 0.1, "output": 0.1},
  "samples": 1, "rays": {"closest": 1, "shadow": 1}, "samplesPerSecond": 0.1,
  "error": {"relative": 0.1, "standardError": [0.1, 0.1, 0.1]}, "mean": [0.1, 0.1, 0.1],
  "effects": [""], "device": "", "seed": 1, "cappedPaths": 1, "carriedPaths": 1,
  "faults": {"nonFinite": 1, "cutTraversal": 1, "stackOverflow": 1, "invalidPdf": 1}})");

void expectKind(const json& value, const json& like, const std::string& where) {
  if (like.is_number_float())
    EXPECT_TRUE(value.is_number()) << where << ": " << value;
  else if (like.is_number())
    EXPECT_TRUE(value.is_number_unsigned()) << where << ": " << value;
  else
    EXPECT_EQ(value.type(), like.type()) << where << ": " << value;
  if (like.is_object()) {
    for (const auto& [key, part] : like.items()) {
      ASSERT_TRUE(value.contains(key)) << where << "." << key;
      expectKind(value[key], part, where + "." + key);
    }
  } else if (like.is_array()) {
    EXPECT_FALSE(value.empty()) << where;
    if (like.size() > 1) {
      EXPECT_EQ(value.size(), like.size()) << where;
    }
    for (const auto& part : value)
      expectKind(part, like.front(), where + "[]");
  }
}

TEST(Outputs, StatsHoldWhatIsPromised) {
  const WorkFolder folder;
  const CommandResult r = vkpt(small({"--stats", "s.json", "--seed", "7"}), {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  const json s = folder.json("s.json");
  expectKind(s, kPromised, "stats");
  EXPECT_EQ(s["schema"], 1);
  EXPECT_EQ(s["scene"], "CornellBox+CornellBlocks");
  EXPECT_EQ(s["width"], 33);
  EXPECT_EQ(s["height"], 17);
  EXPECT_EQ(s["frames"], 5);
  EXPECT_EQ(s["stop"], "frames");
  EXPECT_EQ(s["seed"], 7);
  EXPECT_EQ(s["samples"], 33 * 17 * 5); // blocks that overhang the image count for nothing
  EXPECT_GE(s["rays"]["closest"], s["samples"]);
  EXPECT_GT(s["rays"]["shadow"], 0);
  EXPECT_GT(s["error"]["relative"], 0.0);
  for (const auto& [fault, count] : s["faults"].items())
    EXPECT_EQ(count, 0) << fault;
  for (const auto& [phase, seconds] : s["seconds"].items())
    EXPECT_GE(seconds, 0.0) << phase;
  EXPECT_NEAR(s["samplesPerSecond"].get<double>() * s["seconds"]["render"].get<double>(),
              s["samples"].get<double>(), 1.0);
}

TEST(Outputs, OneSampleTellsNothingOfItsError) {
  const WorkFolder folder;
  const CommandResult r = vkpt({"--frames", "1", "--size", "8x8", "--stats", "s.json"}, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_TRUE(folder.json("s.json")["error"]["relative"].is_null());
  EXPECT_NE(r.out.find("relative error not known"), std::string::npos) << r.out;
}

TEST(Outputs, EveryFormatInOneRun) {
  const WorkFolder folder;
  const CommandResult r =
      vkpt(small({"-o", "a.png", "-o", "b.exr", "-o", "c.hdr", "-o", "d.PFM", "--stats", "s.json"}),
           {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "b.exr", "c.hdr", "d.PFM", "s.json"}));
  const Image exr = readImage(folder / "b.exr");
  const Image pfm = readImage(folder / "d.PFM");
  const json stats = folder.json("s.json");
  std::size_t c = 0;
  for (const char* channel : {"R", "G", "B"}) {
    const auto& values = exr.find(channel)->values;
    EXPECT_EQ(values, pfm.find(channel)->values) << channel;
    double sum = 0.0;
    for (const float v : values)
      sum += static_cast<double>(v);
    EXPECT_NEAR(sum / static_cast<double>(values.size()), stats["mean"][c].get<double>(), 1e-5) << channel;
    ++c;
  }
  for (const char* name : {"a.png", "c.hdr"}) {
    EXPECT_EQ(readImage(folder / name).width, 33);
    EXPECT_EQ(readImage(folder / name).height, 17);
    EXPECT_NE(r.out.find(std::string("written: ") + name), std::string::npos);
  }
}

/// The mean's standard error is that of the pixels, as independent ones.
TEST(Outputs, ExrHoldsStandardErrorsAndTheFiguresOfTheRun) {
  const WorkFolder folder;
  const CommandResult r = vkpt(small({"-o", "x.exr", "--stats", "s.json"}), {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  const json stats = folder.json("s.json");
  const Image image = readImage(folder / "x.exr");
  std::size_t c = 0;
  for (const char* channel : {"stderr.R", "stderr.G", "stderr.B"}) {
    ASSERT_NE(image.find(channel), nullptr) << channel;
    double squares = 0.0;
    for (const float e : image.find(channel)->values)
      squares += static_cast<double>(e) * static_cast<double>(e);
    const double expected = stats["error"]["standardError"][c];
    EXPECT_NEAR(std::sqrt(squares) / static_cast<double>(image.pixelCount()), expected, 1e-5 * expected);
    ++c;
  }
  const Imf::InputFile file((folder / "x.exr").string().c_str());
  const Imf::Header& header = file.header();
  const auto number = [&header](const char* name) {
    const auto* whole = header.findTypedAttribute<Imf::IntAttribute>(name);
    const auto* real = header.findTypedAttribute<Imf::DoubleAttribute>(name);
    return whole != nullptr ? whole->value() : real != nullptr ? real->value() : std::nan("");
  };
  const auto text = [&header](const char* name) {
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
    return attribute == nullptr ? std::string("none") : attribute->value();
  };
  EXPECT_EQ(number("vkpt.frames"), 5.0);
  EXPECT_EQ(number("vkpt.samples"), 33.0 * 17.0 * 5.0);
  EXPECT_EQ(number("vkpt.seed"), 0.0);
  EXPECT_EQ(number("vkpt.rays.closest"), stats["rays"]["closest"].get<double>());
  EXPECT_EQ(number("vkpt.error.relative"), stats["error"]["relative"].get<double>());
  EXPECT_EQ(number("vkpt.seconds.render"), stats["seconds"]["render"].get<double>());
  EXPECT_EQ(number("vkpt.faults.nonFinite"), 0.0);
  EXPECT_EQ(text("vkpt.stop"), "frames");
  EXPECT_EQ(text("vkpt.scene"), "CornellBox+CornellBlocks");
  EXPECT_EQ(text("vkpt.bias"), "");
  EXPECT_EQ(text("vkpt.device"), stats["device"].get<std::string>());
}

TEST(Outputs, ABiasIsNamed) {
  const WorkFolder folder;
  const CommandResult r = vkpt(small({"--max-bounces", "2", "--stats", "s.json"}), {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_EQ(folder.json("s.json")["bias"], json({"--max-bounces 2"}));
  EXPECT_NE(r.out.find("biased by: --max-bounces 2"), std::string::npos) << r.out;
}

TEST(Outputs, AnOldImageIsReplacedAndNothingElseIsLeft) {
  const WorkFolder folder;
  folder.write("x.png", "yesterday's image");
  folder.write("s.json", "yesterday's figures");
  const CommandResult r = vkpt(small({"-o", "x.png", "--stats", "s.json"}), {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  EXPECT_EQ(readImage(folder / "x.png").width, 33);
  EXPECT_EQ(folder.json("s.json")["schema"], 1);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"s.json", "x.png"}));
}

TEST(Outputs, ExposureAndTonemapConcernThePngAlone) {
  const WorkFolder folder;
  const std::vector<std::string> brighter{"-o",         "b.png", "-o",        "b.exr",
                                          "--exposure", "2",     "--tonemap", "none"};
  EXPECT_EQ(vkpt(small({"-o", "a.png", "-o", "a.exr"}), {folder.path(), {}}).exitCode, 0);
  EXPECT_EQ(vkpt(small(brighter), {folder.path(), {}}).exitCode, 0);
  EXPECT_EQ(readImage(folder / "a.exr").find("R")->values, readImage(folder / "b.exr").find("R")->values);
  EXPECT_NE(readImage(folder / "a.png").find("R")->values, readImage(folder / "b.png").find("R")->values);
}

} // namespace
} // namespace vkpt::test
