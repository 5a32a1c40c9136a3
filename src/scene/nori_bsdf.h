#pragma once
// Nori's `bsdf` objects: how a surface scatters.

#include "scene/nori_xml.h"
#include "scene/scene.h"

#include <array>
#include <string_view>

namespace vkpt {

/// Opaque ones are one-sided, as in Nori: black from behind. Throws SceneError; warns of albedos above 1.
Material readNoriBsdf(const XmlElement& bsdf, SceneReport& report);

/// The objects of that name.
inline constexpr std::array<std::string_view, 1> kBsdfTags{"bsdf"};

/// Of a mesh without a bsdf.
Material defaultNoriMaterial();

} // namespace vkpt
