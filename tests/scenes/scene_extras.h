#pragma once
// Strategies by name, what an environment sends, a film, and parts of one.

#include "scenes/check.h"
#include "scenes/made_scenes.h"

namespace vkpt::test {

struct NamedStrategy {
  LightStrategy light;
  const char* name;
};
inline constexpr NamedStrategy kStrategies[] = {
    {LightStrategy::Nee, "nee"}, {LightStrategy::Bsdf, "bsdf"}, {LightStrategy::Mis, "mis"}};
/// The texel that light from `direction` comes from, by the map's definition, in double.
Vec3d radianceFrom(const EnvironmentMap& map, const Vec3d& direction);
/// Irradiance of a surface with unit normal `n`, open to the whole sky above it: midpoint quadrature.
Vec3d skyIrradiance(const EnvironmentMap& map, const Vec3d& n);

/// 64 x 64 pixels.
Film renderAt(Trial& t, const Scene& scene, const EstimatorSettings& estimator, std::uint64_t frames);

/// A closed room of white walls that all emit: paths are long, and every vertex adds light.
Scene glowingRoom();

/// A room of that albedo and emission with a mirror and glass in it, which take no light away: radiance
/// emission / (1 - albedo) wherever the camera looks.
Scene furnaceWithSolids(const Vec3f& albedo, const Vec3f& emission, const Camera& camera);

/// Columns [first, first + count) of an image.
Film columns(const Film& film, int first, int count);
/// Variance of one sample, averaged over the pixels.
Vec3d sampleVariance(const Film& film);

} // namespace vkpt::test
