#pragma once
// Nori's `transform` elements.

#include "core/math.h"
#include "scene/nori_xml.h"

namespace vkpt {

/// The matrix of a <transform>: its children in the order of the document, each multiplied on the left, or
/// the rows in its attribute `value`. Affine and invertible. Throws SceneError.
glm::dmat4 readTransform(const XmlElement& transform);

} // namespace vkpt
