#pragma once
// Named checks of the kernels: each renders a scene whose answer is known. The tests run them on the shipped
// kernels, where they must hold, and on mutated ones, where at least one must not.

#include "scenes/render_fixture.h"
#include "scenes/scene_builder.h"
#include "selftest/case.h"

#include <string>

namespace vkpt::test {

struct Check {
  const char* name;
  void (*run)(Trial&);
};

std::span<const Check> lightChecks();
std::span<const Check> lightTracingChecks();
std::span<const Check> lightTreeChecks();
std::span<const Check> guidingChecks();
std::span<const Check> reuseChecks();
std::span<const Check> pathChecks();
std::span<const Check> filmChecks();
std::span<const Check> deltaChecks();
std::span<const Check> environmentChecks();
std::span<const Check> filterChecks();
std::span<const Check> kindChecks();
std::span<const Check> rouletteChecks();
std::span<const Check> sobolChecks();
std::span<const Check> splittingChecks();
std::span<const Check> strategyChecks();
std::span<const Check> surfaceChecks();
/// All of them, cheap ones first.
std::vector<Check> ownChecks();
/// With the self-test's cases behind them: what the mutations must get past.
std::vector<Check> allChecks();
const Check& checkNamed(const std::string& name);

// What the checks' scenes are made of.
inline constexpr Vec3f kRadiance(3.0F, 2.0F, 1.0F);
inline constexpr Vec3f kAlbedo(0.8F, 0.5F, 0.2F);
inline constexpr Vec3d kUp(0.0, 1.0, 0.0);

/// A diffuse floor at the origin under a quadrilateral light whose two triangles differ in area, seen as one
/// point; and the radiance it must have.
struct LitFloor {
  Scene scene;
  Vec3d radiance;
};
LitFloor litFloor(double scale = 1.0, const Vec3d& offset = Vec3d(0.0));

/// A closed room with two lights and a block: everything that light sampling and BSDF sampling must agree on.
Scene twoLightRoom();

} // namespace vkpt::test
