#pragma once
// A material's BSDF, sampled and evaluated by the shader library in float on the host.

#include "scene/scene.h"

#include <cstdint>
#include <memory>

namespace vkpt {

/// The surface lies in z = 0 and its normal is +z. Directions are unit vectors and point away from it; `wo`
/// is where the light goes to, +z or -z.
class BsdfProbe {
public:
  explicit BsdfProbe(const Material& material);
  ~BsdfProbe();
  BsdfProbe(const BsdfProbe&) = delete;
  BsdfProbe& operator=(const BsdfProbe&) = delete;

  struct Sample {
    Vec3d wi{0.0};
    Vec3d weight{0.0}; ///< f |cos| / density; 0: no light comes this way
  };
  /// Number `index` of the samples of a stream. Streams are independent, and so are those of other seeds.
  [[nodiscard]] Sample sample(const Vec3d& wo, std::uint32_t seed, std::uint32_t stream,
                              std::uint32_t index) const;
  /// Over solid angle, of samples whose weight is not 0.
  [[nodiscard]] double density(const Vec3d& wo, const Vec3d& wi) const;
  /// False for mirrors, smooth glass and metal, and surfaces that scatter nothing.
  [[nodiscard]] bool hasDensity() const;

private:
  struct Program;
  std::unique_ptr<Program> m_program;
};

} // namespace vkpt
