#include "races.h"

#include <fmt/format.h>

namespace vkpt::bench {
namespace {

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
Comparison race(const Turns& turns, const std::string& name, const std::function<double()>& ours,
                const std::function<double()>& yardstick) {
  benchmark::ClearRegisteredBenchmarks();
  add(name + "/vkpt", ours);
  add(name + "/yardstick", yardstick);
  Collector collector;
  for (int round = 0; round < turns.rounds; ++round)
    benchmark::RunSpecifiedBenchmarks(&collector, ".");
  return compare(collector.of(name + "/vkpt"), collector.of(name + "/yardstick"));
}

} // namespace

Comparison racePaths(const Turns& turns, SceneBench& scene) {
  const auto samples = static_cast<double>(scene.samplesPerRun(turns.frames));
  Comparison c = race(
      turns, scene.name(),
      [&] {
        scene.render(turns.frames);
        return samples;
      },
      [&] {
        scene.renderYardstick(turns.frames);
        return samples;
      });
  const std::string disagreement = scene.disagreement();
  if (!disagreement.empty())
    throw Error(ExitCode::Comparison, disagreement);
  c.scene = scene.name();
  c.what = "paths";
  return c;
}

Comparison raceRays(const Turns& turns, SceneBench& scene, SceneBench::RayBench& rays) {
  const auto times = static_cast<int>(2'000'000 / rays.rays.size()) + 1; // a few tenths of a second
  const double count = static_cast<double>(rays.rays.size()) * times;
  Comparison c = race(
      turns, scene.name() + "/" + rays.name,
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
  if (c.disagreement > 1e-3) { // less than one ray of each subgroup's share
    throw Error(ExitCode::Comparison,
                fmt::format("{}: {:.3g} of the {} rays meet something else than by Embree", c.scene,
                            c.disagreement, c.what));
  }
  return c;
}

} // namespace vkpt::bench
