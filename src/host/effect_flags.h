#pragma once
// How a host program knows the scene's effects (kEffectDiffuse, ... in the library): at run time, or, where
// speed is measured, at compile time.

#include "device/effects.h"

namespace vkpt {

struct RuntimeEffects {
  template<std::uint32_t kId>
  class Flag {
  public:
    explicit Flag(const EffectSet& set) : m_on(set.has(static_cast<Effect>(kId))) {}
    operator bool() const { return m_on; } // NOLINT: reads as the shader's constant

  private:
    bool m_on;
  };
};

/// kBits: bit i for the effect with id i.
template<std::uint64_t kBits>
struct FixedEffects {
  template<std::uint32_t kId>
  struct Flag {
    explicit Flag(const EffectSet& /*set*/) {}
    constexpr operator bool() const { return ((kBits >> kId) & 1U) != 0U; } // NOLINT: as above
  };
};

} // namespace vkpt
