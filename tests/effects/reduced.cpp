#include "effects/reduced.h"

#include "gpu/specialised.h"

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace vkpt::test {
namespace {

constexpr spv_target_env kEnvironment = SPV_ENV_VULKAN_1_2;
constexpr std::uint32_t kIds = 64;

/// Collects what the tools say.
class Messages {
public:
  spvtools::MessageConsumer consumer() {
    return [this](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
      m_text += std::string(message) + "\n";
    };
  }
  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(what + ": " + m_text); }

private:
  std::string m_text;
};

} // namespace

EffectIds idsOf(const EffectSet& set) {
  EffectIds ids;
  for (const EffectInfo& e : allEffects()) {
    if (set.has(e.effect))
      ids.push_back(static_cast<std::uint32_t>(e.effect));
  }
  return ids;
}

Spirv reduced(std::span<const std::uint32_t> kernel, const EffectIds& on) {
  gpu::SpecialisationMap constants;
  for (std::uint32_t id = 0; id < kIds; ++id)
    constants[id] = std::ranges::count(on, id) > 0 ? 1U : 0U;
  constants[shared::kConstantReuseEdge] = 2U; // pixels share paths where that effect is on
  const Spirv code = gpu::specialised(kernel, constants);
  Messages messages;
  spvtools::Optimizer optimizer(kEnvironment);
  optimizer.SetMessageConsumer(messages.consumer());
  optimizer.RegisterPass(spvtools::CreateStripDebugInfoPass())
      .RegisterPass(spvtools::CreateSSARewritePass())
      .RegisterPass(spvtools::CreateCCPPass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateBlockMergePass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
      .RegisterPass(spvtools::CreateEliminateDeadConstantPass())
      .RegisterPass(spvtools::CreateCompactIdsPass());
  Spirv result;
  if (!optimizer.Run(code.data(), code.size(), &result))
    messages.fail("spirv-opt");
  spvtools::SpirvTools tools(kEnvironment);
  tools.SetMessageConsumer(messages.consumer());
  if (!tools.Validate(result))
    messages.fail("spirv-val");
  return result;
}

} // namespace vkpt::test
