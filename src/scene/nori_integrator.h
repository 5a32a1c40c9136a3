#pragma once
// Nori's `integrator` and `sampler` objects: what is estimated, and from how many samples.

#include "scene/nori_xml.h"
#include "scene/scene.h"

namespace vkpt {

/// Throws SceneError at an integrator that computes no light transport.
EstimatorDefaults readNoriIntegrator(const XmlElement& integrator, SceneReport& report);

/// Samples for every pixel.
int readNoriSampler(const XmlElement& sampler, SceneReport& report);

} // namespace vkpt
