#pragma once
// Which effects a scene calls for. The list itself is shaders/shared/effects.h.

#include "device/estimator_settings.h"
#include "scene/scene.h"
#include "shared/effects.h"

#include <span>
#include <string>
#include <string_view>

namespace vkpt {

enum class Effect : std::uint32_t {
#define VKPT_ENUMERATOR(id, Name, name, what) Name = id,
  VKPT_EFFECTS(VKPT_ENUMERATOR)
#undef VKPT_ENUMERATOR
};

struct EffectInfo {
  Effect effect;
  std::string_view name;
  std::string_view condition; ///< what must be true of the scene and the options
};
/// Every effect, in the order of its id.
std::span<const EffectInfo> allEffects();

class EffectSet {
public:
  [[nodiscard]] bool has(Effect e) const { return ((m_bits >> static_cast<std::uint32_t>(e)) & 1U) != 0U; }
  void set(Effect e, bool on = true) {
    const std::uint64_t bit = std::uint64_t{1} << static_cast<std::uint32_t>(e);
    m_bits = on ? (m_bits | bit) : (m_bits & ~bit);
  }
  [[nodiscard]] std::vector<std::string> names() const;
  bool operator==(const EffectSet&) const = default;

private:
  std::uint64_t m_bits = 0;
};

/// By effective value: an emitter counts when its radiance and area are above 0, a material when a triangle
/// uses it.
EffectSet detectEffects(const Scene& scene, const EstimatorSettings& settings);

} // namespace vkpt
