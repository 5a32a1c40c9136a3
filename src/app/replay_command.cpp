// `--pixel X,Y --sample I`: one path again, on the host.

#include "app/commands.h"
#include "app/effects_option.h"
#include "app/expanded_options.h"
#include "app/load_scene.h"
#include "host/learn_guide.h"
#include "host/replay.h"

#include <fmt/format.h>

#include <algorithm>

namespace vkpt {
namespace {

std::string vectorText(const Vec3d& v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); }

std::string stepText(const Scene& scene, const ReplayStep& s) {
  const std::string ray =
      fmt::format("  bounce {} from {} towards {}, throughput {}", s.bounce,
                  vectorText(s.origin + scene.origin), vectorText(s.direction), vectorText(s.throughput));
  std::string end = s.hit ? "" : "leaves the scene";
  if (s.hit) {
    const Material& m = scene.materials[scene.triangles[s.triangle].material];
    end = fmt::format("meets triangle {} ({}, {}) after {:.6g}", s.triangle, m.name,
                      s.front ? "front" : "back", s.distance);
  }
  return fmt::format("{}\n    {}, adds {}{}\n", ray, end, vectorText(s.gathered), s.goesOn ? "" : ", ends");
}

/// The first step in which the two programs part; the number of steps if they don't.
std::size_t firstDifference(const Replay& a, const Replay& b) {
  const auto same = [](const ReplayStep& s, const ReplayStep& t) {
    return s.hit == t.hit && s.triangle == t.triangle && s.front == t.front && s.goesOn == t.goesOn &&
           s.branch == t.branch;
  };
  const auto [i, j] = std::ranges::mismatch(a.steps, b.steps, same);
  return static_cast<std::size_t>(i - a.steps.begin());
}

} // namespace

ExitCode runReplay(const RenderOptions& o) {
  SceneReport report;
  const Scene scene = loadSceneFor(o, report);
  const auto [x, y] = *o.pixel;
  if (x >= scene.width || y >= scene.height)
    throw UsageError(
        fmt::format("--pixel {},{}: the image has {}x{} pixels", x, y, scene.width, scene.height));
  const EstimatorSettings estimator = estimatorFor(o, scene);
  const EffectSet effects = compiledEffects(o.effects, detectEffects(scene, estimator));
  const PackedScene packed = packGuided(scene, estimator, effects);
  const HostSettings settings{estimator, scene.width, scene.height, o.seed};
  const Replay single = replay32(packed, scene, effects, settings, x, y, o.sample);
  const Replay twice = replay64(packed, scene, effects, settings, x, y, o.sample);
  fmt::print("{}, pixel {},{} sample {} seed {}\n", scene.name, x, y, o.sample, o.seed);
  for (const auto& [name, replay] : {std::pair{"float32", &single}, std::pair{"float64", &twice}}) {
    fmt::print("{}: {} rays, value {}\n", name, replay->steps.size(), vectorText(replay->value));
    for (const ReplayStep& s : replay->steps)
      fmt::print("{}", stepText(scene, s));
  }
  const std::size_t part = firstDifference(single, twice);
  if (part < std::max(single.steps.size(), twice.steps.size()))
    fmt::print("the two part at ray {}\n", part);
  return ExitCode::Done;
}

} // namespace vkpt
