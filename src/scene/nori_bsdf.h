#pragma once
// Nori's `bsdf` objects: how a surface scatters.

#include "scene/nori_xml.h"
#include "scene/scene.h"

namespace vkpt {

/// Opaque ones are one-sided, as in Nori: black from behind. Throws SceneError; warns of albedos above 1.
Material readNoriBsdf(const XmlElement& bsdf, SceneReport& report);

/// Of a mesh without a bsdf.
Material defaultNoriMaterial();

} // namespace vkpt
