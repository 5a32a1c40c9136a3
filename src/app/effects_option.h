#pragma once
// --effects: which of the effects that a scene calls for are compiled in.

#include "device/effects.h"

#include <string>
#include <vector>

namespace vkpt {

struct EffectsOption {
  bool all = false;  ///< every effect there is, whatever the scene calls for
  EffectSet leftOut; ///< on purpose: biases the image
};

/// "auto", "all" or "auto,-NAME[,-NAME]". Throws UsageError.
EffectsOption parseEffectsOption(const std::string& text);
std::string effectsText(const EffectsOption& option);

/// What is compiled in where the scene calls for `detected`.
EffectSet compiledEffects(const EffectsOption& option, const EffectSet& detected);
/// What was left out though the scene calls for it: "--effects auto,-glass", or nothing.
std::vector<std::string> effectsBias(const EffectsOption& option, const EffectSet& detected);
/// A line for each effect that was left out though the scene does not call for it.
std::vector<std::string> effectsWarnings(const EffectsOption& option, const EffectSet& detected);

} // namespace vkpt
