#pragma once
// What SceneBuilder has no words for: lights without a surface, environments, textures; and one scene with
// all of it. Strategies by name, and parts of a film.

#include "scenes/check.h"

#include <functional>

namespace vkpt::test {

struct NamedStrategy {
  LightStrategy light;
  const char* name;
};
inline constexpr NamedStrategy kStrategies[] = {
    {LightStrategy::Nee, "nee"}, {LightStrategy::Bsdf, "bsdf"}, {LightStrategy::Mis, "mis"}};
EstimatorSettings findingLightBy(LightStrategy light);

/// In the scene's world coordinates.
void addPointLight(Scene& scene, const Vec3d& position, const Vec3f& intensity);
void addDirectionalLight(Scene& scene, const Vec3d& direction, const Vec3f& irradiance);

EnvironmentMap environmentMap(int width, int height,
                              const std::function<Vec3f(int column, int row)>& radiance);
/// The texel that light from `direction` comes from, by the map's definition, in double.
Vec3d radianceFrom(const EnvironmentMap& map, const Vec3d& direction);
/// Irradiance of a surface with unit normal `n`, open to the whole sky above it: midpoint quadrature.
Vec3d skyIrradiance(const EnvironmentMap& map, const Vec3d& n);

Texture textureOf(int width, int height, const std::vector<Vec3f>& texels);
/// Puts a texture on the quad that the scene's last two triangles make, (u, v) given for its corners a to d.
void textureLastQuad(Scene& scene, const Texture& texture, const std::array<Vec2f, 4>& uv);

/// Columns [first, first + count) of an image.
Film columns(const Film& film, int first, int count);
/// Variance of one sample, averaged over the pixels.
Vec3d sampleVariance(const Film& film);

/// Every material and every light at once, in few triangles: nothing closed, so that no sum diverges.
Scene variety();

} // namespace vkpt::test
