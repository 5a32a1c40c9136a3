#include "scaling.h"

#include "accel/bvh.h"
#include "core/clock.h"
#include "scene_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace vkpt::bench {
namespace {

constexpr std::array<std::uint32_t, 6> kTriangles{1'000, 4'000, 16'000, 64'000, 256'000, 1'000'000};

/// By the clock, since threads that work at once are what it is about: the shortest, for others' work only
/// adds.
double buildSeconds(const Scene& scene, unsigned threads, int rounds) {
  std::vector<Box3f> boxes(scene.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const std::uint32_t v : scene.triangles[i].vertex)
      boxes[i].extend(scene.positions[v]);
  double shortest = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const Stopwatch watch;
    buildBvh(boxes, {.threads = threads});
    shortest = std::min(shortest, watch.seconds());
  }
  return shortest;
}

/// Least squares of y = a + b x.
struct Line {
  double a = 0.0;
  double b = 0.0;
  Line(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sx += x[i];
      sy += y[i];
      sxx += x[i] * x[i];
      sxy += x[i] * y[i];
    }
    b = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    a = (sy - b * sx) / n;
  }
};

} // namespace

nlohmann::json measureScaling(const gpu::Context& context, const Turns& turns, int size) {
  fmt::print("{:>10} {:>10} {:>10} {:>14} {:>14} {:>12} {:>12}\n", "triangles", "us/sample", "yardstick",
             "Mbounces/s", "yardstick", "build s, 1", "2 threads");
  nlohmann::json rows = nlohmann::json::array();
  std::vector<double> logarithms;
  std::vector<double> times;
  for (const std::uint32_t wanted : kTriangles) {
    SceneBench scene(context, "ball", boxWithBall(wanted, size));
    const Comparison paths = racePaths(turns, scene);
    Comparison bounces{};
    for (const auto& rays : scene.rayBenches()) {
      if (rays->name == "bounce")
        bounces = raceRays(turns, scene, *rays);
    }
    const std::size_t triangles = scene.scene().triangles.size();
    const double one = buildSeconds(scene.scene(), 1, turns.rounds);
    const double two = buildSeconds(scene.scene(), 2, turns.rounds);
    logarithms.push_back(std::log2(static_cast<double>(triangles)));
    times.push_back(1.0 / paths.oursCore);
    fmt::print("{:10} {:10.3f} {:10.3f} {:14.3f} {:14.3f} {:12.4f} {:12.4f}\n", triangles, times.back(),
               1.0 / paths.yardstickCore, bounces.oursCore, bounces.yardstickCore, one, two);
    std::fflush(stdout);
    rows.push_back({{"triangles", triangles},
                    {"microseconds", times.back()},
                    {"yardstickMicroseconds", 1.0 / paths.yardstickCore},
                    {"bounces", bounces.oursCore},
                    {"yardstickBounces", bounces.yardstickCore},
                    {"buildSecondsOneThread", one},
                    {"buildSecondsTwoThreads", two}});
  }
  const Line fit(logarithms, times);
  double worst = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i)
    worst = std::max(worst, std::abs(times[i] / (fit.a + fit.b * logarithms[i]) - 1.0));
  fmt::print("time of a sample = {:.3f} us + {:.3f} us log2(triangles), within {:.1f} %\n", fit.a, fit.b,
             1e2 * worst);
  return {{"rows", rows}, {"fit", {{"a", fit.a}, {"b", fit.b}, {"worst", worst}}}};
}

} // namespace vkpt::bench
