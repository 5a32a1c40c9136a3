#pragma once
// What SceneBuilder has no words for: lights without a surface, environments, textures; one scene with all of
// it; and settings of the estimator. Needs no device.

#include "device/estimator_settings.h"
#include "scenes/scene_builder.h"
#include "selftest/settings.h"

#include <functional>

namespace vkpt::test {

EstimatorSettings findingLightBy(LightStrategy light);

/// In the scene's world coordinates.
void addPointLight(Scene& scene, const Vec3d& position, const Vec3f& intensity);
void addDirectionalLight(Scene& scene, const Vec3d& direction, const Vec3f& irradiance);

EnvironmentMap environmentMap(int width, int height,
                              const std::function<Vec3f(int column, int row)>& radiance);
Texture textureOf(int width, int height, const std::vector<Vec3f>& texels);
/// Puts a texture on the quad that the scene's last two triangles make, (u, v) given for its corners a to d.
void textureLastQuad(Scene& scene, const Texture& texture, const std::array<Vec2f, 4>& uv);

/// Every material and every light at once, in few triangles: nothing closed, so that no sum diverges.
Scene variety();
/// The same with all the rest that an effect can be asked for by: rough materials, a background, a filter.
Scene everything();
/// And by the options.
EstimatorSettings everyOption();

} // namespace vkpt::test
