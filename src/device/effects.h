#pragma once
// Which effects a scene calls for. The list itself is shaders/shared/effects.h.

#include "device/estimator_settings.h"
#include "scene/scene.h"
#include "shared/effects.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace vkpt {

enum class Effect : std::uint32_t {
#define VKPT_ENUMERATOR(id, Name, name, what) Name = id,
  VKPT_EFFECTS(VKPT_ENUMERATOR)
#undef VKPT_ENUMERATOR
};

inline constexpr std::size_t kEffectIds = 64; ///< ids are below: positions in a bit set

struct EffectInfo {
  Effect effect;
  std::string_view name;
  std::string_view condition; ///< what must be true of the scene and the options
};
/// Every effect, in the order of its id.
std::span<const EffectInfo> allEffects();
std::string_view effectName(Effect effect);

class EffectSet {
public:
  static EffectSet all();
  static EffectSet of(Effect e) {
    EffectSet set;
    set.set(e);
    return set;
  }
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

/// `set` without the effects in `leftOut`, and without those that mean nothing once these are gone: no
/// weights of two strategies, no table of lights, without light sampling; no rough metal without a
/// distribution.
EffectSet without(const EffectSet& set, const EffectSet& leftOut);

/// Why an effect is on or off.
struct EffectReason {
  std::string because;  ///< the object or the option that decides: "material 'glass'"
  SourceLocation where; ///< of the object; no file: an option, or a scene made in code
  /// "material 'glass' (box.mtl:12)"
  [[nodiscard]] std::string text() const;
};

struct EffectReasons {
  EffectSet set;
  std::array<EffectReason, kEffectIds> byId;
  [[nodiscard]] const EffectReason& of(Effect e) const { return byId[static_cast<std::size_t>(e)]; }
};

/// What a scene calls for under these settings, by effective value: an emitter counts when its radiance and
/// area are above 0, a material when a triangle uses it, a shading normal when it is not the triangle's own.
/// Each effect comes with the first object that calls for it, or with what comes nearest to it.
EffectReasons explainEffects(const Scene& scene, const EstimatorSettings& settings);
/// The same without the reasons.
EffectSet detectEffects(const Scene& scene, const EstimatorSettings& settings);

/// The option that paths which pixels share can't go together with, if they are asked for.
std::optional<std::string> pathReuseObstacle(const EstimatorSettings& settings);

/// Whether every corner's shading normal is the triangle's own, up to an angle that changes a cosine by less
/// than 1e-5; true without shading normals.
bool isFlat(const Scene& scene, const Triangle& triangle);

} // namespace vkpt
