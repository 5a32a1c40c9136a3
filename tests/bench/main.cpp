// vkpt against the yardstick, in one run, taking turns: rays and paths a second on one core, and two threads
// against one. Prints a table and a line of JSON; exits 1 if the two sides don't compute the same.

#include "bench_scene.h"
#include "measurements.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>

namespace vkpt::bench {
namespace {

struct Options {
  std::vector<std::string> scenes{"blocks", "spheres", "busts"};
  fs::path mesh;
  int rounds = 5;
  int size = 512;
  std::uint64_t frames = 16;
  bool rays = true;
  bool paths = true;
  bool threads = true;
  bool child = false; ///< measure one scene with LP_NUM_THREADS as it is, print the rate, end
};

SceneChoice choose(const std::string& name, const Options& o) {
  if (name == "blocks")
    return {name, {"CornellBox.obj", "CornellBlocks.obj"}};
  if (name == "spheres")
    return {name, {"CornellBox.obj", "CornellLeftSphere.obj", "CornellRightSphere.obj"}};
  if (name == "mesh")
    return {name, {"CornellBox.obj", o.mesh}};
  if (name == "busts")
    return {name, {fs::path(VKPT_SOURCE_DIR) / "assets/busts.xml"}};
  throw UsageError(fmt::format("--scenes {}: blocks, spheres, busts or mesh", name));
}

/// Registers work() under `name`; it returns the items it did.
void add(const std::string& name, const std::function<double()>& work) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [work](benchmark::State& state) {
                                 double items = 0.0;
                                 for (auto _ : state)
                                   items += work();
                                 state.counters["items"] = items;
                               })
      ->Iterations(1)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

/// Both sides in turns, round by round.
Comparison race(const Options& o, const std::string& name, const std::function<double()>& ours,
                const std::function<double()>& yardstick) {
  benchmark::ClearRegisteredBenchmarks();
  add(name + "/vkpt", ours);
  add(name + "/yardstick", yardstick);
  Collector collector;
  for (int round = 0; round < o.rounds; ++round)
    benchmark::RunSpecifiedBenchmarks(&collector, ".");
  return compare(collector.of(name + "/vkpt"), collector.of(name + "/yardstick"));
}

Comparison racePaths(const Options& o, SceneBench& scene) {
  const auto samples = static_cast<double>(scene.samplesPerRun(o.frames));
  Comparison c = race(
      o, scene.name(),
      [&] {
        scene.render(o.frames);
        return samples;
      },
      [&] {
        scene.renderYardstick(o.frames);
        return samples;
      });
  const std::string disagreement = scene.disagreement();
  if (!disagreement.empty())
    throw Error(ExitCode::Comparison, disagreement);
  c.scene = scene.name();
  c.what = "paths";
  return c;
}

Comparison raceRays(const Options& o, SceneBench& scene, SceneBench::RayBench& rays) {
  const auto times = static_cast<int>(2'000'000 / rays.rays.size()) + 1; // a few tenths of a second
  const double count = static_cast<double>(rays.rays.size()) * times;
  Comparison c = race(
      o, scene.name() + "/" + rays.name,
      [&] {
        for (int i = 0; i < times; ++i)
          rays.probe.trace();
        return count;
      },
      [&] {
        for (int i = 0; i < times; ++i)
          rays.runEmbree(scene.embree());
        return count;
      });
  c.scene = scene.name();
  c.what = rays.name;
  c.disagreement = rays.disagreement();
  // Embree's default traversal is not watertight, rays that graze an edge may go either way, and distances on
  // a floor far larger than what stands on it round differently.
  if (c.disagreement > 5e-3) {
    throw Error(ExitCode::Comparison,
                fmt::format("{}: {:.3g} of the {} rays meet something else than by Embree", c.scene,
                            c.disagreement, c.what));
  }
  return c;
}

/// Adds the rates of a process of its own with so many threads of lavapipe.
void addRatesOfChild(Rates& rates, const Options& o, const std::string& scene, int threads) {
  const std::string command = fmt::format(
      "LP_NUM_THREADS={} exec '{}' --child --scenes {} --mesh '{}' --size {} --frames {}", threads,
      fs::read_symlink("/proc/self/exe").string(), scene, o.mesh.string(), o.size, o.frames);
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr)
    throw Error(ExitCode::Comparison, "cannot start: " + command);
  double wall = 0.0;
  double core = 0.0;
  const int read = std::fscanf(pipe, "%lf %lf", &wall, &core);
  if (pclose(pipe) != 0 || read != 2)
    throw Error(ExitCode::Comparison, "failed: " + command);
  rates.wall.push_back(wall);
  rates.core.push_back(core);
}

Comparison raceThreads(const Options& o, const std::string& scene) {
  Rates one;
  Rates two;
  for (int round = 0; round < o.rounds; ++round) {
    addRatesOfChild(one, o, scene, 1);
    addRatesOfChild(two, o, scene, 2);
  }
  Comparison c = compare(two, one);
  c.scene = scene;
  c.what = "2 threads / 1";
  return c;
}

/// Processor time of the thread of this process that has had most so far: where the machine is busy with
/// other things, all that can be said of how well threads share the work.
double secondsOfBusiestThread() {
  double most = 0.0;
  for (const auto& task : fs::directory_iterator("/proc/self/task")) {
    double nanoseconds = 0.0;
    std::ifstream(task.path() / "schedstat") >> nanoseconds;
    most = std::max(most, 1e-9 * nanoseconds);
  }
  return most;
}

void runChild(const Options& o) {
  const gpu::Context context;
  DeviceBench scene(context, choose(o.scenes.at(0), o), o.size);
  const double before = secondsOfBusiestThread();
  const double seconds = scene.render(o.frames);
  const double busy = secondsOfBusiestThread() - before;
  const double samples = static_cast<double>(scene.samplesPerRun(o.frames)) * 1e-6;
  fmt::print("{} {}\n", samples / seconds, samples / busy);
}

class Table {
public:
  explicit Table(const std::string& device) : m_json{{"schema", 1}, {"device", device}} {
    fmt::print("one core of {}; millions a second, medians; ratios: vkpt / yardstick\n", device);
    fmt::print("{:<10} {:<14} {:>8} {:>10} {:>7} {:>9} {:>7} {:>9}\n", "scene", "what", "vkpt", "yardstick",
               "ratio", "cpu ratio", "lowest", "disagree");
  }
  void add(const Comparison& c) {
    fmt::print("{:<10} {:<14} {:8.3f} {:10.3f} {:7.3f} {:9.3f} {:7.3f} {:9.2g}\n", c.scene, c.what, c.ours,
               c.yardstick, c.ratio, c.coreRatio, c.lowest, c.disagreement);
    std::fflush(stdout);
    m_json["results"].push_back({{"scene", c.scene},
                                 {"what", c.what},
                                 {"vkpt", c.ours},
                                 {"yardstick", c.yardstick},
                                 {"ratio", c.ratio},
                                 {"cpuRatio", c.coreRatio},
                                 {"lowest", c.lowest},
                                 {"disagreement", c.disagreement}});
  }
  void finish() const { fmt::print("{}\n", m_json.dump()); }

private:
  nlohmann::json m_json;
};

void runAll(const Options& o) {
  const gpu::Context context;
  Table table(context.info().name);
  for (const std::string& name : o.scenes) {
    SceneBench scene(context, choose(name, o), o.size);
    if (o.paths)
      table.add(racePaths(o, scene));
    for (const auto& rays : scene.rayBenches()) {
      if (o.rays)
        table.add(raceRays(o, scene, *rays));
    }
  }
  for (const std::string& name : o.scenes) {
    if (o.threads)
      table.add(raceThreads(o, name));
  }
  table.finish();
}

int run(int argc, char** argv) {
  Options o;
  CLI::App app("vkpt against Embree, on the same work");
  app.add_option("--scenes", o.scenes, "blocks, spheres, busts (Phong), mesh")->delimiter(',');
  app.add_option("--mesh", o.mesh,
                 "OBJ file that stands in the box in place of the blocks; adds the scene `mesh`");
  app.add_option("--rounds", o.rounds, "turns each side takes")->check(CLI::PositiveNumber);
  app.add_option("--size", o.size, "pixels along an edge, a multiple of 8")->check(CLI::PositiveNumber);
  app.add_option("--frames", o.frames, "samples a pixel and turn")->check(CLI::PositiveNumber);
  app.add_flag("!--no-rays", o.rays, "leave out the recorded rays");
  app.add_flag("!--no-paths", o.paths, "leave out the paths");
  app.add_flag("!--no-threads", o.threads, "leave out two threads against one");
  app.add_flag("--child", o.child, "print one scene's Msamples/s with LP_NUM_THREADS as it is");
  CLI11_PARSE(app, argc, argv);
  if (!o.mesh.empty() && app.count("--scenes") == 0)
    o.scenes.emplace_back("mesh");
  if (o.child) {
    runChild(o);
    return 0;
  }
  if (o.size % static_cast<int>(shared::kBlockEdge) != 0)
    throw UsageError(fmt::format("--size {}: not a multiple of {}", o.size, shared::kBlockEdge));
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
    fmt::print(stderr, "vkpt-bench: {}\n", e.what());
    return 1;
  }
}
