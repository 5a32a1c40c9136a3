#pragma once
// Materials by effective value: what they do, not what they are called.

#include "scene/scene.h"

#include <vector>

namespace vkpt {

/// How a surface with this material scatters in effect: without a specular lobe it is diffuse, and with
/// facets that hardly differ in direction smooth.
BsdfType effectiveBsdf(const Material& material);
/// False for a surface that reflects nothing, such as a lamp.
bool scatters(const Material& material);
/// Glass, smooth or rough.
bool transmits(const Material& material);
/// Whether its facets have a distribution to choose: rough metal or rough glass in effect.
bool hasFacets(const Material& material);
/// Glass with the same index on both sides that neither absorbs nor emits: light passes it as if it were not
/// there.
bool isNothing(const Material& material);
/// Whether it has a texture on which what it scatters depends.
bool readsTexture(const Material& material);

/// The scene's materials, a texture of one colour turned into that colour.
std::vector<Material> effectiveMaterials(const Scene& scene);

} // namespace vkpt
