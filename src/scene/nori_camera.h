#pragma once
// Nori's `camera` objects: view, image size and pixel filter.

#include "scene/nori_xml.h"
#include "scene/scene.h"

#include <string_view>

namespace vkpt {

/// Sets Scene's camera, filter, width and height. Throws SceneError, too, where toWorld distorts the picture:
/// it may turn, move, mirror, and scale in all directions alike.
void readNoriCamera(const XmlElement& camera, Scene& scene, SceneReport& report);

/// As `rfilter` types call it.
std::string_view noriFilterName(PixelFilter::Shape shape);

} // namespace vkpt
