#include "app/explain_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace vkpt {
namespace {

std::string_view stateOf(const ExplainReport& r, Effect e) {
  const bool called = r.reasons.set.has(e);
  const bool compiled = r.compiled.has(e);
  if (called == compiled)
    return called ? "on" : "off";
  return called ? "left out" : "forced";
}

const EffectCost* costOf(const ExplainReport& r, Effect e) {
  const auto found = std::ranges::find(r.costs, e, &EffectCost::effect);
  return found == r.costs.end() ? nullptr : &*found;
}

/// "1.23 MB", three digits.
std::string sizeText(std::uint64_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (bytes < 1000)
    return fmt::format("{} B", bytes);
  if (value < 1e6)
    return fmt::format("{:.3g} kB", value * 1e-3);
  return value < 1e9 ? fmt::format("{:.3g} MB", value * 1e-6) : fmt::format("{:.3g} GB", value * 1e-9);
}

std::string costText(const EffectCost* cost) {
  if (cost == nullptr)
    return "-";
  return fmt::format("{}{:+.1f} % +-{:.1f}", cost->samePaths ? "" : "~", (cost->ratio - 1.0) * 100.0,
                     cost->spread * 100.0);
}

std::string effectTable(const ExplainReport& r) {
  const bool measured = !r.costs.empty();
  const auto row = [measured](std::string_view name, std::string_view state, std::string_view cost,
                              std::string_view bytes, std::string_view because) {
    return measured ? fmt::format("{:<16} {:<8} {:>16} {:>8}  {}\n", name, state, cost, bytes, because)
                    : fmt::format("{:<16} {:<8} {:>8}  {}\n", name, state, bytes, because);
  };
  std::string text = row("effect", "", "time a ray", "buffers", "because of");
  for (std::size_t i = 0; i < allEffects().size(); ++i) {
    const EffectInfo& e = allEffects()[i];
    text += row(e.name, stateOf(r, e.effect), costText(costOf(r, e.effect)),
                r.bytes[i] == 0 ? "-" : sizeText(r.bytes[i]), r.reasons.of(e.effect).text());
  }
  return text;
}

std::string memoryTable(const MemoryPlan& plan) {
  std::string text = fmt::format("{:<22} {:>8}  {:>14}\n", "device memory", "takes", "largest buffer");
  for (const MemoryRow& m : plan.rows) {
    text += fmt::format("{:<22} {:>8}  {:>14}  of {} ({}){}\n", m.what, sizeText(m.bytes),
                        sizeText(m.largestBuffer), sizeText(m.limitBytes), m.limit,
                        m.largestBuffer > m.limitBytes ? " TOO LARGE" : "");
  }
  text += fmt::format("{:<22} {:>8}  {:>14}  of {} (largest heap){}\n", "all", sizeText(plan.bytes()), "",
                      sizeText(plan.heapBytes), plan.bytes() > plan.heapBytes ? " TOO LARGE" : "");
  return text;
}

nlohmann::ordered_json effectJson(const ExplainReport& r, std::size_t i) {
  const EffectInfo& e = allEffects()[i];
  const EffectReason& reason = r.reasons.of(e.effect);
  nlohmann::ordered_json j;
  j["name"] = e.name;
  j["on"] = r.reasons.set.has(e.effect);
  j["compiled"] = r.compiled.has(e.effect);
  j["because"] = reason.because;
  using Json = nlohmann::ordered_json;
  j["file"] = reason.where.file.empty() ? Json() : Json(reason.where.file);
  j["line"] = reason.where.line == 0 ? Json() : Json(reason.where.line);
  j["needs"] = e.condition;
  j["bytes"] = r.bytes[i];
  if (const EffectCost* cost = costOf(r, e.effect)) {
    j["cost"] = {{"ratio", cost->ratio},
                 {"spread", cost->spread},
                 {"nanosecondsWith", cost->nanosecondsWith},
                 {"nanosecondsWithout", cost->nanosecondsWithout},
                 {"samePaths", cost->samePaths}};
  } else {
    j["cost"] = nullptr;
  }
  return j;
}

} // namespace

std::string explainText(const ExplainReport& r) {
  std::string text;
  for (const auto& note : r.notes)
    text += note + "\n";
  text +=
      fmt::format("{}: {} triangles, {}x{}, on {}\n\n", r.scene, r.triangles, r.width, r.height, r.device);
  text += effectTable(r);
  if (!r.costs.empty()) {
    text +=
        fmt::format("time a ray: with the effect over without it, at {0}x{0} pixels, median of {1} turns, "
                    "+- half the distance of the quartiles; ~ without it the paths are others; - without "
                    "it paths may not end\n",
                    r.costSettings.edge, r.costSettings.turns);
  }
  return text + "\n" + memoryTable(r.memory);
}

std::string explainJson(const ExplainReport& r) {
  nlohmann::ordered_json j;
  j["schema"] = 1;
  j["version"] = VKPT_VERSION;
  j["scene"] = r.scene;
  j["triangles"] = r.triangles;
  j["width"] = r.width;
  j["height"] = r.height;
  j["device"] = r.device;
  for (std::size_t i = 0; i < allEffects().size(); ++i)
    j["effects"].push_back(effectJson(r, i));
  for (const MemoryRow& m : r.memory.rows) {
    j["memory"].push_back({{"what", m.what},
                           {"bytes", m.bytes},
                           {"largestBuffer", m.largestBuffer},
                           {"limit", m.limit},
                           {"limitBytes", m.limitBytes}});
  }
  j["bytes"] = r.memory.bytes();
  j["heapBytes"] = r.memory.heapBytes;
  j["fits"] = r.memory.fits();
  j["notes"] = r.notes;
  return j.dump(2) + "\n";
}

} // namespace vkpt
