// Roulette with a constant probability: its mean, its variance, and where it starts.
#include "scenes/scene_extras.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::test {
namespace {

EstimatorSettings endingWith(double probability, std::optional<std::uint32_t> after = {}) {
  EstimatorSettings s = bsdfSampling(RouletteMode::Constant);
  s.termination = probability;
  s.rouletteAfter = after;
  return s;
}

/// The variance is finite where survival is above the square of the albedo: here at every q.
void furnaceByConstant(Trial& t) {
  const Vec3f albedo(0.1F, 0.25F, 0.4F);
  for (const double q : {0.1, 0.4, 0.7}) {
    t.expectMean(renderAt(t, furnace(albedo), endingWith(q), 64), 1.0 / (1.0 - Vec3d(albedo)), 0.008,
                 fmt::format("q = {}", q));
  }
}

/// One bounce in a furnace: 1 before roulette may end a path, and albedo / survival if it does not: the
/// variance of that is albedo^2 q / (1 - q). Not a path ends earlier than it may.
void rouletteStartsWhereItShould(Trial& t) {
  const Vec3d albedo(0.5, 0.25, 0.75);
  const Scene scene = furnace(Vec3f(albedo));
  const double q = 0.4;
  t.expectConstant(renderAt(t, scene, withBounces(endingWith(q), 1), 16), 1.0 + albedo, 0,
                   "after 2 by default");
  t.expectConstant(renderAt(t, scene, withBounces(endingWith(q, 4), 3), 4),
                   1.0 + albedo + albedo * albedo + albedo * albedo * albedo, 0, "after 4, 3 bounces");
  const Film film = renderAt(t, scene, withBounces(endingWith(q, 1), 1), 40);
  t.expectMean(film, 1.0 + albedo, 0.01, "after 1");
  const Vec3d ratio = sampleVariance(film) / (albedo * albedo * (q / (1.0 - q)));
  for (int c = 0; c < 3; ++c)
    t.expect(std::abs(ratio[c] - 1.0) < 0.02,
             fmt::format("variance is {:.4f} of what q = {} gives", ratio[c], q));
}

constexpr Check kRouletteChecks[] = {
    {"rouletteStartsWhereItShould", rouletteStartsWhereItShould},
    {"furnaceByConstant", furnaceByConstant},
};

} // namespace

std::span<const Check> rouletteChecks() { return kRouletteChecks; }

} // namespace vkpt::test
