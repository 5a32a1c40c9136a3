// Draws of every BSDF on the device against its density in double; weights against f cos / pdf.
#include "bsdf/sampling_checks.h"

#include <algorithm>

namespace vkpt::test {
namespace {

BsdfBench& shippedBench() {
  static BsdfBench bench;
  return bench;
}

class Bsdf : public RenderTest, public testing::WithParamInterface<MaterialCase> {
protected:
  template<class Check>
  static void inEveryView(const Check& check) {
    for (const BsdfCase& c : bsdfCases()) {
      if (materialCases()[c.view.material].name != GetParam().name)
        continue;
      for (const std::string& failure : check(c))
        ADD_FAILURE() << failure;
    }
  }
};

TEST_P(Bsdf, IsSampledByItsDensity) {
  inEveryView([](const BsdfCase& c) { return checkDensity(shippedBench(), c, bsdfCases().size()); });
}

TEST_P(Bsdf, WeighsSamplesRight) {
  inEveryView([](const BsdfCase& c) { return checkWeights(shippedBench(), c); });
}

TEST_P(Bsdf, IsInFloatWhatItIsInDouble) {
  inEveryView([](const BsdfCase& c) { return checkEvaluation(shippedBench(), c); });
}

INSTANTIATE_TEST_SUITE_P(Of, Bsdf, testing::ValuesIn(materialCases().begin(), materialCases().end()),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           std::erase_if(name, [](char c) { return std::isalnum(c) == 0; });
                           return name;
                         });

} // namespace
} // namespace vkpt::test
