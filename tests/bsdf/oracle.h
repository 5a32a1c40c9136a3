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

private:
  struct Library;
  std::unique_ptr<Library> m_library;
};

} // namespace vkpt::test
