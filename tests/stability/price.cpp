// What stability costs in time: the Cornell box with the robust geometry and with a naive one (Moeller and
// Trumbore's triangle test, rays that start an absolute epsilon off the surface), in turns in one run, from
// one test build of the kernel.
#include "scenes/render_fixture.h"
#include "scenes/test_shaders.h"

#include "scene/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <sys/resource.h>

namespace vkpt::test {
namespace {

constexpr int kRounds = 15;

/// Of all threads of the process, in seconds: other programs on the machine matter little to it.
double processorTime() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

struct Speed {
  double samples = 0.0; ///< millions a second of one core
  double rays = 0.0;
};

Speed speedOf(selftest::Studio& studio) {
  const RunCounters before = studio.integrator().counters(); // of all renders so far
  const double begin = processorTime();
  const RunCounters after = studio.render().counters;
  const double millionSeconds = 1e6 * (processorTime() - begin);
  const auto rays = [](const RunCounters& c) { return static_cast<double>(c.raysClosest + c.raysShadow); };
  return {static_cast<double>(after.samples - before.samples) / millionSeconds,
          (rays(after) - rays(before)) / millionSeconds};
}

template<class Of>
double median(std::vector<Speed> speeds, const Of& of) {
  std::ranges::nth_element(speeds, speeds.begin() + kRounds / 2, {}, of);
  return of(speeds[kRounds / 2]);
}

void compare(const char* name) {
  const std::array<fs::path, 1> files{name};
  SceneReport report;
  const Scene scene = loadScene(files, report);
  const gpu::Context context;
  const auto studioWith = [&](std::uint32_t mutation) {
    selftest::RenderSetup setup{.width = 256, .height = 256, .frames = 16};
    setup.kernel = mutatedKernel(mutation);
    return selftest::Studio(context, scene, setup);
  };
  selftest::Studio robust = studioWith(0);
  selftest::Studio naive = studioWith(static_cast<std::uint32_t>(GeometryMutation::NaiveGeometry));
  static_cast<void>(speedOf(robust)); // compiles
  static_cast<void>(speedOf(naive));
  std::vector<Speed> robustSpeeds;
  std::vector<Speed> naiveSpeeds;
  for (int round = 0; round < kRounds; ++round) {
    robustSpeeds.push_back(speedOf(robust));
    naiveSpeeds.push_back(speedOf(naive));
  }
  const auto samples = [](const Speed& s) { return s.samples; };
  const auto rays = [](const Speed& s) { return s.rays; };
  fmt::print("| {} | {:.3g} | {:.3g} | {:.1f} % | {:.3g} | {:.3g} |\n", name, median(robustSpeeds, samples),
             median(naiveSpeeds, samples),
             100.0 * (median(naiveSpeeds, samples) / median(robustSpeeds, samples) - 1.0),
             median(robustSpeeds, rays), median(naiveSpeeds, rays));
}

} // namespace
} // namespace vkpt::test

int main() {
  fmt::print("| scene | Msamples/s: robust | naive | price | Mrays/s: robust | naive |\n| --- | --- | --- | "
             "--- | --- | --- |\n");
  for (const char* name : {"cornell", "cornell-spheres"})
    vkpt::test::compare(name);
}
