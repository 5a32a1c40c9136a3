#pragma once
// What is demanded of a scene, however long it takes. Each tells its figures.

#include "calibration/calibration.h"

#include <gtest/gtest.h>

namespace vkpt::test {

/// `error.relative` is within a tenth of what the seeds differ by; the scatter of the image's mean, and of
/// each pixel, has the distribution that the standard errors say. Pixels are left out where paths from the
/// lights bring splats: these are rare, not normal.
void expectCalibrated(const Scene& scene, std::uint32_t seeds, std::uint64_t frames,
                      const EstimatorSettings& estimator = {});

/// With this target the true relative error, against a reference of so many frames, is at most 1.1 times it
/// in nine of ten seeds.
void expectTargetKept(const Scene& scene, double target, std::uint32_t seeds, std::uint64_t referenceFrames,
                      const EstimatorSettings& estimator = {});

/// What a slope is taken over. A frame's time is constant on a quiet machine alone.
enum class SlopeOver { frames, framesAndTime };

/// The slope of log relMSE over log frames, and over log time, is -1 by a t-test over the seeds, whose
/// standard error is below 0.1.
void expectSlopeOfIndependentSamples(const Scene& scene, std::uint32_t seeds, std::uint64_t frames,
                                     SlopeOver over);

} // namespace vkpt::test
