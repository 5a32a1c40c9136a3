// What leaving out buys: kernels of what a scene calls for against kernels with more in them, on one core, in
// turns, in one run; and the time to compile them, by Mesa without its cache. Prints a table and a line of
// JSON.

#include "measurements.h"

#include "render/render_loop.h"
#include "scene/load.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <ctime>
#include <memory>

namespace vkpt::bench {
namespace {

struct Options {
  std::vector<std::string> scenes{"cornell",         "cornell-spheres", "cbox.xml",
                                  "cbox-meshes.xml", "busts.xml",       "q-scene.xml"};
  int rounds = 5;
  int size = 128;
  std::uint64_t frames = 16;
};

/// Seconds of this process on a processor: what others run does not count.
double processorSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Scene load(const std::string& name, int size) {
  fs::path path(name);
  if (path.has_extension() && !path.has_parent_path())
    path = fs::path(VKPT_SOURCE_DIR) / "assets" / path;
  SceneReport report;
  Scene scene = loadScene({&path, 1}, report);
  scene.width = scene.height = size;
  return scene;
}

/// One kernel, compiled when it is made.
class Kernel {
public:
  Kernel(const gpu::Context& context, const DeviceScene& packed, const Scene& scene,
         const EffectSet& effects) {
    const double before = processorSeconds();
    IntegratorSettings settings;
    settings.width = scene.width;
    settings.height = scene.height;
    m_integrator = std::make_unique<Integrator>(context, packed, scene, effects, settings);
    m_integrator->warmUp();
    m_compileSeconds = processorSeconds() - before;
  }
  [[nodiscard]] double compileSeconds() const { return m_compileSeconds; }

  void run(std::uint64_t frames, Rates& rates) {
    RenderJob job;
    job.frames = frames;
    RenderObserver observer;
    Film film;
    m_integrator->clear();
    const double before = processorSeconds();
    const double seconds = renderUntil(*m_integrator, film, job, observer).seconds;
    const double samples = 1e-6 * static_cast<double>(frames * film.pixels.size());
    rates.wall.push_back(samples / seconds);
    rates.core.push_back(samples / (processorSeconds() - before));
  }

private:
  std::unique_ptr<Integrator> m_integrator;
  double m_compileSeconds = 0.0;
};

/// What a kernel has beside what the scene calls for.
struct More {
  const char* name;
  EffectSet effects;
};

EffectSet boxMaterials() {
  EffectSet set;
  for (const Effect e :
       {Effect::Diffuse, Effect::Mirror, Effect::Glass, Effect::Metal, Effect::SmoothNormals})
    set.set(e);
  return set;
}
EffectSet everyMaterial() {
  EffectSet set;
#define VKPT_SET(Name, Type) set.set(Effect::Name);
  VKPT_BSDFS(VKPT_SET)
#undef VKPT_SET
  for (const Effect e :
       {Effect::SmoothNormals, Effect::Textures, Effect::Absorption, Effect::Ggx, Effect::Beckmann})
    set.set(e);
  return set;
}

EffectSet together(const EffectSet& a, const EffectSet& b) {
  EffectSet both = a;
  for (const EffectInfo& e : allEffects()) {
    if (b.has(e.effect))
      both.set(e.effect);
  }
  return both;
}

void race(const Options& o, const gpu::Context& context, const std::string& name, nlohmann::json& json) {
  const Scene scene = load(name, o.size);
  const EffectSet own = detectEffects(scene, {});
  const DeviceScene packed = uploadScene(context, packScene(scene, {}, EffectSet::all()));
  for (const More& more : {More{"box materials", boxMaterials()}, More{"all materials", everyMaterial()},
                           More{"everything", EffectSet::all()}}) {
    Kernel specialised(context, packed, scene, own);
    Kernel other(context, packed, scene, together(own, more.effects));
    Rates ours;
    Rates theirs;
    for (int round = 0; round < o.rounds; ++round) {
      specialised.run(o.frames, ours);
      other.run(o.frames, theirs);
    }
    const Comparison c = compare(ours, theirs);
    fmt::print("{:<16} {:<14} {:8.3f} {:8.3f} {:7.3f} {:9.3f} {:8.2f} {:8.2f}\n", name, more.name, c.ours,
               c.yardstick, c.ratio, c.coreRatio, specialised.compileSeconds(), other.compileSeconds());
    std::fflush(stdout);
    json["results"].push_back({{"scene", name},
                               {"more", more.name},
                               {"specialised", c.ours},
                               {"with", c.yardstick},
                               {"ratio", c.ratio},
                               {"cpuRatio", c.coreRatio},
                               {"compileSeconds", specialised.compileSeconds()},
                               {"compileSecondsWith", other.compileSeconds()}});
  }
}

int run(int argc, char** argv) {
  Options o;
  CLI::App app("kernels of what a scene calls for against kernels with more in them");
  app.add_option("--scenes", o.scenes, "built-in names, files, or names of files in assets/")->delimiter(',');
  app.add_option("--rounds", o.rounds, "turns each kernel takes")->check(CLI::PositiveNumber);
  app.add_option("--size", o.size, "pixels along an edge")->check(CLI::PositiveNumber);
  app.add_option("--frames", o.frames, "samples a pixel and turn")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  setenv("LP_NUM_THREADS", "1", 1); // before the driver is loaded
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  const gpu::Context context;
  nlohmann::json json{{"schema", 2}, {"benchmark", "effects"}, {"device", context.info().name}};
  fmt::print("one core of {}; million samples a second, medians of {}; ratio: without over with\n",
             context.info().name, o.rounds);
  fmt::print("{:<16} {:<14} {:>8} {:>8} {:>7} {:>9} {:>17}\n", "scene", "with", "without", "with", "ratio",
             "cpu ratio", "compile s: w/o, with");
  for (const std::string& scene : o.scenes)
    race(o, context, scene, json);
  fmt::print("{}\n", json.dump());
  return 0;
}

} // namespace
} // namespace vkpt::bench

int main(int argc, char** argv) {
  try {
    return vkpt::bench::run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "vkpt-bench-effects: {}\n", e.what());
    return 1;
  }
}
