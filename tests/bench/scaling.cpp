#include "scaling.h"

#include "accel/bvh.h"
#include "core/clock.h"
#include "scene_choice.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace vkpt::bench {
namespace {

constexpr std::uint32_t kSmallest = 1'000;
constexpr std::uint32_t kLargest = 1'000'000;
constexpr double kGrowth = 3.981071705534973; // ten times in 5/3 steps: 1 k, 4 k, 16 k, 63 k, 251 k, 1 M

/// By the clock: threads that work at once are what it is about.
double buildSeconds(const Scene& scene, unsigned threads, int rounds) {
  std::vector<Box3f> boxes(scene.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const std::uint32_t v : scene.triangles[i].vertex)
      boxes[i].extend(scene.positions[v]);
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round) {
    const Stopwatch watch;
    buildBvh(boxes, {.threads = threads});
    seconds.push_back(watch.seconds());
  }
  return median(seconds);
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
  for (double wanted = kSmallest; wanted < 1.1 * kLargest; wanted *= kGrowth) {
    SceneBench scene(context, "ball", boxWithBall(static_cast<std::uint32_t>(std::lround(wanted)), size));
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
