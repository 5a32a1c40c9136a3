#include "selftest/bsdf_means.h"

#include "selftest/bsdf_probe.h"
#include "selftest/luminance.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt {

void testBsdfMeans(const NoriTTest& test, std::uint32_t seed, const TellOutcome& tell) {
  const double level = sidakLevel(test.significanceLevel, test.references.size());
  std::uint32_t stream = 0;
  for (const Material& bsdf : test.bsdfs) {
    const BsdfProbe probe(bsdf);
    for (const double angle : test.angles) {
      const double theta = angle * std::numbers::pi / 180.0;
      const Vec3d wo(std::sin(theta), 0.0, std::cos(theta));
      RunningMoments weights;
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(test.sampleCount); ++i)
        weights.add(luminanceOf(probe.sample(wo, seed, stream, i).weight));
      const double reference = test.references[stream];
      const MeanEstimate mean = meanOf(weights);
      tell({bsdf.where, fmt::format("{} at {:g} degrees", bsdf.name, angle),
            fmt::format("mean {:.6g}, reference {:g}", mean.mean, reference), studentTest(mean, reference),
            level});
      ++stream;
    }
  }
}

} // namespace vkpt
