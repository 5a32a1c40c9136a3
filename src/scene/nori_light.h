#pragma once
// Nori's `emitter` objects, which its edition of 2015 calls `luminaire`.

#include "scene/nori_xml.h"
#include "scene/scene.h"
#include "scene/sources.h"

#include <array>
#include <string_view>

namespace vkpt {

inline constexpr std::array<std::string_view, 2> kNoriLightTags{"emitter", "luminaire"};

/// The radiance of a light in a mesh. Throws SceneError.
Vec3f readNoriAreaLight(const XmlElement& light, SceneReport& report);

/// Adds a light that stands in <scene>; Scene::origin has to be known. Images are not read: their file is in
/// EnvironmentMap::file. Throws SceneError.
void addNoriLight(const XmlElement& light, const SceneText& source, Scene& scene, SceneReport& report);

} // namespace vkpt
