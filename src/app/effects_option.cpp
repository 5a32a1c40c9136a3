#include "app/effects_option.h"

#include "app/option_values.h"
#include "scene/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vkpt {
namespace {

Effect parseEffect(std::string_view name, const std::string& text) {
  std::vector<std::string_view> names;
  for (const EffectInfo& e : allEffects()) {
    if (e.name == name)
      return e.effect;
    names.push_back(e.name);
  }
  const std::string near = didYouMean(name, names);
  throw UsageError(fmt::format("--effects '{}': no effect '{}'{}", shown(text), shown(name),
                               near.empty() ? fmt::format("; there are {}", fmt::join(names, ", ")) : near));
}

std::string leftOutText(const EffectSet& leftOut) {
  std::string text = "auto";
  for (const auto& name : leftOut.names())
    text += ",-" + name;
  return text;
}

} // namespace

EffectsOption parseEffectsOption(const std::string& text) {
  EffectsOption option;
  option.all = text == "all";
  if (option.all || text == "auto")
    return option;
  constexpr std::string_view kAuto = "auto,";
  constexpr const char* kRight = "auto, all or auto,-NAME[,-NAME]";
  if (!text.starts_with(kAuto))
    refuseValue("--effects", shown(text), kRight);
  std::string_view rest = std::string_view(text).substr(kAuto.size());
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    if (!part.starts_with('-'))
      refuseValue("--effects", shown(text), kRight);
    option.leftOut.set(parseEffect(part.substr(1), text));
    more = comma != std::string_view::npos;
    if (more)
      rest.remove_prefix(comma + 1);
  }
  return option;
}

std::string effectsText(const EffectsOption& option) {
  return option.all ? "all" : leftOutText(option.leftOut);
}

EffectSet compiledEffects(const EffectsOption& option, const EffectSet& detected) {
  return option.all ? EffectSet::all() : without(detected, option.leftOut);
}

std::vector<std::string> effectsBias(const EffectsOption& option, const EffectSet& detected) {
  EffectSet missed;
  for (const EffectInfo& e : allEffects())
    missed.set(e.effect, option.leftOut.has(e.effect) && detected.has(e.effect));
  if (missed == EffectSet())
    return {};
  return {"--effects " + leftOutText(missed)};
}

std::vector<std::string> effectsWarnings(const EffectsOption& option, const EffectSet& detected) {
  std::vector<std::string> warnings;
  for (const EffectInfo& e : allEffects()) {
    if (option.leftOut.has(e.effect) && !detected.has(e.effect))
      warnings.push_back(fmt::format("--effects auto,-{}: the scene does not call for it (it needs {}), so "
                                     "leaving it out changes nothing",
                                     e.name, e.condition));
  }
  return warnings;
}

} // namespace vkpt
