#pragma once
// What `vkpt explain` says, from one struct: a table for people, JSON for scripts.

#include "device/effects.h"
#include "render/effect_costs.h"
#include "render/memory_plan.h"

#include <string>
#include <vector>

namespace vkpt {

struct ExplainReport {
  std::string scene;
  std::size_t triangles = 0;
  int width = 0;
  int height = 0;
  std::string device;
  EffectReasons reasons;            ///< what the scene calls for
  EffectSet compiled;               ///< by --effects
  std::vector<std::uint64_t> bytes; ///< of each effect's own buffers, in the order of allEffects()
  std::vector<EffectCost> costs;    ///< empty: not measured
  CostSettings costSettings;
  MemoryPlan memory;
  std::vector<std::string> notes;
};

std::string explainText(const ExplainReport& report);
/// schema 1; the README tells the keys.
std::string explainJson(const ExplainReport& report);

} // namespace vkpt
