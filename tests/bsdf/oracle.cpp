#include "bsdf/oracle.h"

#include "host/program64.h"

namespace vkpt::test {

struct Oracle::Library {
  host64::Program<RuntimeEffects> program;
};

Oracle::Oracle(const PackedScene& scene, const shared::FrameConstants& constants, const EffectSet& effects)
    : m_library(std::make_unique<Library>(Library{{scene, constants, effects, RouletteMode::Throughput}})) {}
Oracle::~Oracle() = default;

OracleValue Oracle::evaluate(const View& view, const Vec3d& wo, const Vec3d& wi) const {
  auto& program = m_library->program;
  host64::Program<RuntimeEffects>::Surface s{};
  s.n = glm::normalize(Vec3d(view.n));
  s.ng = s.n;
  s.front = view.front;
  s.m = program.material(view.material);
  if (!program.scattersTo(s, wi))
    return {};
  const auto value = program.evaluateBsdf(s, wo, wi);
  return {value.f, value.pdf_w};
}

OracleValue Oracle::evaluate(const View& view, const Vec3d& wi) const {
  return evaluate(view, glm::normalize(Vec3d(view.wo)), wi);
}

double Oracle::treeProbability(std::uint32_t leaf, const Vec3d& p, const Vec3d& n) const {
  return m_library->program.treeProbability(leaf, true, p, n, m_library->program.lightTableAt(p, n));
}

} // namespace vkpt::test
