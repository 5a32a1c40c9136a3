#pragma once
#include "device/estimator_settings.h"
#include "gpu/context.h"
#include "scene/nori_tests.h"
#include "selftest/outcome.h"

#include <cstdint>
#include <functional>
#include <utility>

namespace vkpt {

/// The mean luminance of each scene's image, rendered on the device, against its reference. The image plane
/// is divided as suits the number of samples, whatever the file's resolution; reconstruction filters have no
/// part in the mean. Faults fail the test.
void testSceneMeans(const NoriTTest& test, const gpu::Context& context,
                    const std::function<EstimatorSettings(const Scene&)>& estimatorOf, std::uint32_t seed,
                    const TellOutcome& tell);

} // namespace vkpt
