// What a second of one core buys: the error of the default estimator and of parts of it at equal processor
// time, in turns, against a reference by the plain kernel (light sampling alone, independent samples, paths
// from the eye). Prints a table and a line of JSON.

#include "measurements.h"
#include "scene_choice.h"
#include "study/setting_run.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>

namespace vkpt::bench {
namespace {

struct Options {
  std::vector<std::string> scenes{"blocks", "spheres", "busts", "million", "lights", "ceiling", "tiles"};
  fs::path mesh;
  fs::path folder = ".";
  int size = 128;
  double seconds = 2.5; ///< of one core for each render
  int rounds = 5;
  double referenceSeconds = 300.0;
  fs::path makeReference; ///< render the first scene's into this file, end
};

struct Named {
  const char* name;
  EstimatorSettings estimator;
};
const std::array<Named, 7> kEstimators{{
    {"plain", {.light = LightStrategy::Nee}},
    {"sobol, mis", {.sampler = Sampler::Sobol}},
    {"and the tree of lights", {.sampler = Sampler::Sobol, .lightSelection = LightSelection::Auto}},
    {"and light tracing",
     {.sampler = Sampler::Sobol, .lightSelection = LightSelection::Auto, .lightTracing = LightTracing::Auto}},
    {"and specular samples",
     {.sampler = Sampler::Sobol,
      .lightSelection = LightSelection::Auto,
      .lightTracing = LightTracing::Auto,
      .specularSamples = 4}},
    {"and guided directions",
     {.sampler = Sampler::Sobol,
      .lightSelection = LightSelection::Auto,
      .lightTracing = LightTracing::Auto,
      .guiding = Guiding::Auto,
      .specularSamples = 4}},
    {"and shared paths",
     {.sampler = Sampler::Sobol,
      .lightSelection = LightSelection::Auto,
      .lightTracing = LightTracing::Auto,
      .guiding = Guiding::Auto,
      .specularSamples = 4,
      .pathReuse = 64}},
}};

StudySetting settingOf(const Scene& scene, const EstimatorSettings& estimator) {
  StudySetting s;
  s.estimator = estimator;
  s.filter = scene.filter;
  s.effects = detectEffects(scene, estimator);
  return s;
}

/// Of all threads of this process: lavapipe's, and the one that waits for it.
double processorSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The lamp, and two pixels round it, are left out: what its edge does is the reconstruction filter's affair.
std::vector<bool> mask(const Image& reference) {
  const int w = reference.width;
  const int h = reference.height;
  float brightest = 0.0F;
  for (std::size_t c = 0; c < 3; ++c)
    brightest = std::max(brightest, *std::ranges::max_element(reference.channels[c].values));
  std::vector<bool> kept(reference.pixelCount(), true);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      if (reference.channels[0].values[static_cast<std::size_t>(y * w + x)] > 0.25F * brightest)
        for (int j = std::max(0, y - 2); j <= std::min(h - 1, y + 2); ++j)
          for (int i = std::max(0, x - 2); i <= std::min(w - 1, x + 2); ++i)
            kept[static_cast<std::size_t>(j * w + i)] = false;
  return kept;
}

/// Mean squared error over the kept pixels and the channels, the reference's own noise taken off; and that
/// noise.
struct Judged {
  double mse = 0.0;
  double noise = 0.0;
};
Judged judge(const Film& film, const Image& reference, const std::vector<bool>& kept) {
  Judged j;
  std::size_t count = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i])
      continue;
    ++count;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d =
          film.pixels[i].mean[static_cast<int>(c)] - static_cast<double>(reference.channels[c].values[i]);
      const double se = static_cast<double>(reference.channels[c + 3].values[i]);
      j.mse += (d * d - se * se) / 3.0;
      j.noise += se * se / 3.0;
    }
  }
  j.mse /= static_cast<double>(count);
  j.noise /= static_cast<double>(count);
  return j;
}

void makeReference(const Options& o) {
  const gpu::Context context;
  const Scene scene = loadByName(o.scenes.at(0), o.size, o.mesh);
  SettingRun run(context, scene, settingOf(scene, kEstimators[0].estimator));
  run.restart(0xFFFFFFFFU);
  while (!run.finished(std::nullopt, o.referenceSeconds))
    run.step(std::nullopt, o.referenceSeconds);
  writeImage(o.makeReference, develop(run.film()), {}, {});
}

Image referenceOf(const Options& o, const std::string& scene) {
  const fs::path file = o.folder / fmt::format("reference-{}-{}-{:g}.exr", scene, o.size, o.referenceSeconds);
  if (!fs::exists(file)) {
    fmt::print(stderr, "{}: rendering the reference, {:g} s\n", scene, o.referenceSeconds);
    const std::string command = fmt::format("env -u LP_NUM_THREADS '{}' --make-reference '{}' --scenes '{}' "
                                            "--mesh '{}' --size {} --reference-seconds {}",
                                            fs::read_symlink("/proc/self/exe").string(), file.string(), scene,
                                            o.mesh.string(), o.size, o.referenceSeconds);
    if (std::system(command.c_str()) != 0)
      throw Error(ExitCode::Comparison, "failed: " + command);
  }
  return readImage(file);
}

/// One estimator on one scene: a figure a round.
struct Entry {
  const char* name;
  std::unique_ptr<SettingRun> run;
  std::vector<double> rmse, efficiency, rate;
};

/// Those that walk other paths than the one before: without caustics nothing is traced from the lights.
std::vector<Entry> entriesFor(const gpu::Context& context, const Scene& scene) {
  std::vector<Entry> entries;
  EffectSet before;
  for (const Named& n : kEstimators) {
    const StudySetting setting = settingOf(scene, n.estimator);
    if (setting.effects == before)
      continue;
    before = setting.effects;
    entries.push_back({n.name, std::make_unique<SettingRun>(context, scene, setting), {}, {}, {}});
  }
  return entries;
}

/// Returns the reference's own noise.
double takeTurn(const Options& o, Entry& e, std::uint32_t round, const Image& reference,
                const std::vector<bool>& kept) {
  e.run->restart(round);
  const double start = processorSeconds();
  double spent = 0.0;
  // Whole groups of samples; what goes beyond the time is part of the account.
  while ((spent = processorSeconds() - start) < o.seconds)
    e.run->step(std::nullopt, std::nullopt);
  const Judged j = judge(e.run->film(), reference, kept);
  e.rmse.push_back(std::sqrt(std::max(j.mse, 0.0) * spent / o.seconds)); // as for o.seconds
  e.efficiency.push_back(1.0 / (std::max(j.mse, 1e-30) * spent));
  e.rate.push_back(static_cast<double>(e.run->frames()) * o.size * o.size / spent * 1e-6);
  return j.noise;
}

void report(const std::string& scene, const Entry& e, const Entry& plain, double noise,
            nlohmann::json& json) {
  const double ratio = median(e.rmse) / median(plain.rmse);
  const double gain = median(e.efficiency) / median(plain.efficiency);
  const double own = std::sqrt(noise) / median(e.rmse);
  fmt::print("{:<16} {:<22} {:8.3f} {:9.5f} {:10.3f} {:10.1f} {:10.2f} {:10.2f}\n", scene, e.name,
             median(e.rate), median(e.rmse), ratio, median(e.efficiency), gain, own);
  std::fflush(stdout);
  json["results"].push_back({{"scene", scene},
                             {"estimator", e.name},
                             {"samplesPerSecond", 1e6 * median(e.rate)},
                             {"rmse", median(e.rmse)},
                             {"ofPlain", ratio},
                             {"efficiency", median(e.efficiency)},
                             {"overPlain", gain},
                             {"referenceNoise", own}});
}

void runAll(const Options& o) {
  const gpu::Context context;
  nlohmann::json json{{"schema", 2},
                      {"benchmark", "errors"},
                      {"device", context.info().name},
                      {"size", o.size},
                      {"seconds", o.seconds}};
  fmt::print("one core of {}, {}x{}, {:g} s of processor time each, medians of {}\n", context.info().name,
             o.size, o.size, o.seconds, o.rounds);
  fmt::print("{:<16} {:<22} {:>8} {:>9} {:>10} {:>10} {:>10} {:>10}\n", "scene", "estimator", "Msamp/s",
             "RMSE", "of plain", "efficiency", "over plain", "reference");
  for (const std::string& name : o.scenes) {
    const Image reference = referenceOf(o, name);
    const std::vector<bool> kept = mask(reference);
    const Scene scene = loadByName(name, o.size, o.mesh);
    std::vector<Entry> entries = entriesFor(context, scene);
    double noise = 0.0;
    for (int round = 0; round < o.rounds; ++round)
      for (Entry& e : entries)
        noise = takeTurn(o, e, static_cast<std::uint32_t>(round), reference, kept);
    for (const Entry& e : entries)
      report(name, e, entries.front(), noise, json);
  }
  fmt::print("{}\n", json.dump());
}

int run(int argc, char** argv) {
  Options o;
  CLI::App app("the error that a core second buys; `reference`: its noise over the error that it judges");
  app.add_option("--scenes", o.scenes, kSceneNames)->delimiter(',');
  app.add_option("--mesh", o.mesh, "OBJ file that stands in the box; adds the scene `mesh`");
  app.add_option("--folder", o.folder, "where references are kept");
  app.add_option("--size", o.size, "pixels along an edge")->check(CLI::PositiveNumber);
  app.add_option("--seconds", o.seconds, "of processor time for each render")->check(CLI::PositiveNumber);
  app.add_option("--rounds", o.rounds, "turns each estimator takes")->check(CLI::PositiveNumber);
  app.add_option("--reference-seconds", o.referenceSeconds, "of a reference, on all cores")
      ->check(CLI::PositiveNumber);
  app.add_option("--make-reference", o.makeReference,
                 "render the first scene's reference into this file, end");
  CLI11_PARSE(app, argc, argv);
  if (!o.mesh.empty() && app.count("--scenes") == 0)
    o.scenes.insert(o.scenes.begin() + 3, "mesh");
  if (!o.makeReference.empty()) {
    makeReference(o);
    return 0;
  }
  setenv("LP_NUM_THREADS", "1", 1); // before the driver is loaded
  runAll(o);
  return 0;
}

} // namespace
} // namespace vkpt::bench

int main(int argc, char** argv) {
  try {
    return vkpt::bench::run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "vkpt-bench-errors: {}\n", e.what());
    return 1;
  }
}
