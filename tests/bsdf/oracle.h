#pragma once
// The same library in double on the host: densities to integrate, values to compare with.

#include "bsdf/probe.h"

#include <memory>

namespace vkpt::test {

struct OracleValue {
  Vec3d f{0.0};
  double pdf_w = 0.0;
};

class Oracle {
public:
  Oracle(const PackedScene& scene, const shared::FrameConstants& constants, const EffectSet& effects);
  ~Oracle();
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  /// Zero where the surface doesn't scatter. Vectors needn't be as rounded as `view`'s.
  [[nodiscard]] OracleValue evaluate(const View& view, const Vec3d& wi) const;
  [[nodiscard]] OracleValue evaluate(const View& view, const Vec3d& wo, const Vec3d& wi) const;
  /// With which the light tree leads to a leaf, for a surface at p (0: of no side).
  [[nodiscard]] double treeProbability(std::uint32_t leaf, const Vec3d& p, const Vec3d& n) const;

private:
  struct Library;
  std::unique_ptr<Library> m_library;
};

} // namespace vkpt::test
