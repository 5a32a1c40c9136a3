// vkpt compare IMAGE REFERENCE: how far an image is from a reference, for people and for scripts.

#include "app/commands.h"
#include "app/option_parser.h"
#include "app/option_values.h"
#include "film/compare.h"
#include "film/file_io.h"
#include "scene/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include <array>
#include <cmath>

namespace vkpt {
namespace {

struct Limit {
  const char* option;
  const char* metric;
  double (*of)(const ImageDifference&);
  std::optional<double> most;
};

struct CompareOptions {
  std::vector<fs::path> images; ///< the image, its reference
  fs::path json;
  fs::path picture;
  bool quiet = false;
  std::array<Limit, 4> limits{{
      {"--max-mse", "MSE", [](const auto& d) { return d.mse; }, {}},
      {"--max-rmse", "RMSE", [](const auto& d) { return d.rmse; }, {}},
      {"--max-rel-mse", "relMSE", [](const auto& d) { return d.relMse; }, {}},
      {"--max-z", "|z|", [](const auto& d) { return std::abs(d.z().value()); }, {}},
  }};
  [[nodiscard]] bool limitsZ() const { return limits.back().most.has_value(); }
};

constexpr const char* kHelp = "vkpt compare --help";

void checkExtension(const char* option, const fs::path& path, const char* extension) {
  if (lowerCase(path.extension().string()) != extension)
    refuseValue(option, path.string(), fmt::format("a name that ends in {}", extension));
}

bool parse(const std::vector<std::string>& arguments, CompareOptions& o) {
  CLI::App app("How far IMAGE is from REFERENCE: .exr, .hdr, .pfm or .png (decoded to linear), of one size.\n"
               "Metrics on stdout; pixels that are not finite are left out, and counted.",
               "vkpt compare");
  app.footer("Exit codes: 0 done, 1 usage, 2 an image that cannot be read, or sizes that differ, 4 a limit "
             "was exceeded");
  app.add_option("IMAGES", o.images, "the image, then its reference")->type_name("");
  addValue(
      app, "--json", "FILE.json",
      [&o](const auto& text) {
        o.json = text;
        checkExtension("--json", o.json, ".json");
      },
      "write the metrics");
  addValue(
      app, "-o,--output", "FILE.png",
      [&o](const auto& text) {
        o.picture = text;
        checkExtension("--output", o.picture, ".png");
      },
      "write a picture of the relative difference: 0.1 % (black) to 100 % (pale yellow), logarithmic");
  for (Limit& limit : o.limits) {
    addValue(
        app, limit.option, "X",
        [&limit](const auto& text) {
          limit.most = parseFinite(limit.option, text, "a number, 0 or more");
          if (*limit.most < 0.0)
            refuseValue(limit.option, text, "a number, 0 or more");
        },
        fmt::format("exit with 4 when the {} is larger", limit.metric));
  }
  app.add_flag("--quiet", o.quiet, "errors only");
  if (!parseArguments(app, arguments, kHelp))
    return false;
  if (o.images.size() != 2)
    throw UsageError(
        fmt::format("compare: {} images; give two, the image and its reference", o.images.size()));
  return true;
}

/// Before anything is read.
void checkOutputs(const CompareOptions& o) {
  if (!o.picture.empty())
    checkOutputPath(o.picture);
  if (!o.json.empty())
    const film::AtomicFile trial(o.json); // not committed: removed again
}

ImageDifference compare(const CompareOptions& o, const Image& image, const Image& reference) {
  if (image.width != reference.width || image.height != reference.height) {
    throw SceneError({o.images[0].string()},
                     fmt::format("{}x{} pixels, but {} has {}x{}; only images of one size can be compared",
                                 image.width, image.height, o.images[1].string(), reference.width,
                                 reference.height));
  }
  const ImageDifference d = compareImages(image, reference);
  if (d.pixels == 0)
    throw SceneError({o.images[0].string()}, "no pixel is finite in it and in the reference");
  if (o.limitsZ() && !d.z()) {
    throw SceneError(
        {o.images[0].string()},
        "no standard errors (layers stderr.R, stderr.G, stderr.B of an EXR), which --max-z needs");
  }
  return d;
}

std::string text(const ImageDifference& d) {
  std::string t =
      fmt::format("MSE {:.6g}, RMSE {:.6g}, relMSE {:.6g} (relative error {:.3g} %), PSNR {:.2f} dB\n", d.mse,
                  d.rmse, d.relMse, std::sqrt(d.relMse) * 100.0, d.psnr);
  t += fmt::format("mean difference {:.4g} {:.4g} {:.4g}", d.meanDifference.x, d.meanDifference.y,
                   d.meanDifference.z);
  if (d.zByChannel)
    t += fmt::format(", z {:.2f} {:.2f} {:.2f}\n", d.zByChannel->x, d.zByChannel->y, d.zByChannel->z);
  else
    t += ", z not known: the image tells no standard errors\n";
  if (d.nonFinite > 0)
    t += fmt::format("left out: {} pixels that are not finite\n", d.nonFinite);
  return t;
}

std::string json(const ImageDifference& d) {
  const auto rgb = [](const Vec3d& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
  nlohmann::ordered_json j;
  j["mse"] = d.mse;
  j["rmse"] = d.rmse;
  j["relMse"] = d.relMse;
  j["psnr"] = d.psnr; // infinite becomes null
  j["meanDifference"] = rgb(d.meanDifference);
  j["z"] = d.z() ? nlohmann::ordered_json(*d.z()) : nullptr;
  j["zByChannel"] = d.zByChannel ? rgb(*d.zByChannel) : nullptr;
  j["pixels"] = d.pixels;
  j["nonFinitePixels"] = d.nonFinite;
  return j.dump(2) + "\n";
}

/// Every limit that is exceeded; empty where all hold.
std::vector<std::string> exceeded(const CompareOptions& o, const ImageDifference& d) {
  std::vector<std::string> lines;
  for (const Limit& limit : o.limits) {
    if (limit.most && !(limit.of(d) <= *limit.most))
      lines.push_back(
          fmt::format("{} {:.6g} is above {} {:g}", limit.metric, limit.of(d), limit.option, *limit.most));
  }
  return lines;
}

} // namespace

ExitCode runCompare(const std::vector<std::string>& arguments) {
  CompareOptions o;
  if (!parse(arguments, o))
    return ExitCode::Done;
  checkOutputs(o);
  const Image image = readImage(o.images[0]);
  const Image reference = readImage(o.images[1]);
  const ImageDifference d = compare(o, image, reference);
  if (!o.quiet)
    fmt::print("{}", text(d));
  if (!o.picture.empty())
    writeImage(o.picture, differencePicture(image, reference), {0.0, Tonemap::None}, {});
  if (!o.json.empty())
    film::writeTextFile(o.json, json(d));
  const auto lines = exceeded(o, d);
  if (lines.empty())
    return ExitCode::Done;
  spdlog::error("{}: {}", o.images[0].string(), fmt::join(lines, ", "));
  return ExitCode::Comparison;
}

} // namespace vkpt
