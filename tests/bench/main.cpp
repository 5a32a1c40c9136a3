// vkpt against the yardstick, in one run, taking turns: rays and paths a second on one core, and two threads
// against one; or how time grows with the number of triangles. Prints a table and a line of JSON; exits 1 if
// the two sides don't compute the same.

#include "races.h"
#include "scaling.h"
#include "scene_choice.h"
#include "thread_race.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>

namespace vkpt::bench {
namespace {

struct Options {
  std::vector<std::string> scenes{"blocks", "spheres", "busts", "million", "lights"};
  fs::path mesh;
  Turns turns;
  int size = 512;
  bool rays = true;
  bool paths = true;
  bool threads = true;
  bool scaling = false;
  bool child = false; ///< measure one scene with LP_NUM_THREADS as it is, print the rate, end
};

ChildJob childJob(const Options& o, const std::string& scene) {
  return {scene, o.mesh, o.size, o.turns.frames};
}

class Table {
public:
  explicit Table(const std::string& device)
      : m_json{{"schema", 2}, {"benchmark", "yardstick"}, {"device", device}} {
    fmt::print("one core of {}; millions a second, medians; ratios: vkpt / yardstick\n", device);
    fmt::print("{:<10} {:<14} {:>8} {:>10} {:>7} {:>9} {:>7} {:>9}\n", "scene", "what", "vkpt", "yardstick",
               "ratio", "cpu ratio", "lowest", "disagree");
  }
  void add(const Comparison& c, std::size_t triangles) {
    fmt::print("{:<10} {:<14} {:8.3f} {:10.3f} {:7.3f} {:9.3f} {:7.3f} {:9.2g}\n", c.scene, c.what, c.ours,
               c.yardstick, c.ratio, c.coreRatio, c.lowest, c.disagreement);
    std::fflush(stdout);
    m_json["results"].push_back({{"scene", c.scene},
                                 {"triangles", triangles},
                                 {"what", c.what},
                                 {"vkpt", c.ours},
                                 {"yardstick", c.yardstick},
                                 {"ratio", c.ratio},
                                 {"vkptCpu", c.oursCore},
                                 {"yardstickCpu", c.yardstickCore},
                                 {"cpuRatio", c.coreRatio},
                                 {"lowest", c.lowest},
                                 {"disagreement", c.disagreement}});
  }
  void finish() const { fmt::print("{}\n", m_json.dump()); }

private:
  nlohmann::json m_json;
};

void runScenes(const Options& o) {
  const gpu::Context context;
  Table table(context.info().name);
  for (const std::string& name : o.scenes) {
    SceneBench scene(context, name, loadByName(name, o.size, o.mesh));
    const std::size_t triangles = scene.scene().triangles.size();
    if (o.paths)
      table.add(racePaths(o.turns, scene), triangles);
    for (const auto& rays : scene.rayBenches()) {
      if (o.rays)
        table.add(raceRays(o.turns, scene, *rays), triangles);
    }
    if (o.threads)
      table.add(raceThreads(childJob(o, name), o.turns.rounds), triangles);
  }
  table.finish();
}

void runScaling(const Options& o) {
  const gpu::Context context;
  nlohmann::json json{{"schema", 2}, {"benchmark", "scaling"}, {"device", context.info().name}};
  fmt::print("one core of {}, medians, time of the processor; the build by the clock, shortest\n",
             context.info().name);
  json.update(measureScaling(context, o.turns, o.size));
  fmt::print("{}\n", json.dump());
}

int run(int argc, char** argv) {
  Options o;
  CLI::App app("vkpt against Embree, on the same work");
  app.add_option("--scenes", o.scenes, kSceneNames)->delimiter(',');
  app.add_option("--mesh", o.mesh,
                 "OBJ file that stands in the box in place of the blocks; adds the scene `mesh`");
  app.add_option("--rounds", o.turns.rounds, "turns each side takes")->check(CLI::PositiveNumber);
  app.add_option("--size", o.size, "pixels along an edge, a multiple of 8")->check(CLI::PositiveNumber);
  app.add_option("--frames", o.turns.frames, "samples a pixel and turn")->check(CLI::PositiveNumber);
  app.add_flag("!--no-rays", o.rays, "leave out the recorded rays");
  app.add_flag("!--no-paths", o.paths, "leave out the paths");
  app.add_flag("!--no-threads", o.threads, "leave out two threads against one");
  app.add_flag("--scaling", o.scaling, "one shape in 1 k to 1 M triangles instead of the scenes");
  app.add_flag("--child", o.child, "print one scene's Msamples/s with LP_NUM_THREADS as it is");
  CLI11_PARSE(app, argc, argv);
  if (!o.mesh.empty() && app.count("--scenes") == 0)
    o.scenes.insert(o.scenes.begin() + 3, "mesh");
  if (o.child) {
    runChild(childJob(o, o.scenes.at(0)));
    return 0;
  }
  if (o.size % static_cast<int>(shared::kBlockEdge) != 0)
    throw UsageError(fmt::format("--size {}: not a multiple of {}", o.size, shared::kBlockEdge));
  setenv("LP_NUM_THREADS", "1", 1); // before the driver is loaded
  if (o.scaling)
    runScaling(o);
  else
    runScenes(o);
  return 0;
}

} // namespace
} // namespace vkpt::bench

int main(int argc, char** argv) {
  try {
    return vkpt::bench::run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "vkpt-bench: {}\n", e.what());
    return 1;
  }
}
