#include "scenes/check.h"

namespace vkpt::test {

std::vector<Check> ownChecks() {
  std::vector<Check> checks;
  for (const auto& some :
       {filmChecks(), lightChecks(), deltaChecks(), surfaceChecks(), environmentChecks(), filterChecks(),
        rouletteChecks(), sobolChecks(), kindChecks(), splittingChecks(), strategyChecks(), pathChecks(),
        lightTracingChecks(), lightTreeChecks(), reuseChecks(), guidingChecks()})
    checks.insert(checks.end(), some.begin(), some.end());
  return checks;
}

std::vector<Check> allChecks() {
  std::vector<Check> checks = ownChecks();
  for (const Case& c : allCases())
    checks.push_back({c.name, c.run});
  return checks;
}

const Check& checkNamed(const std::string& name) {
  static const std::vector<Check> checks = allChecks();
  for (const Check& c : checks) {
    if (c.name == name)
      return c;
  }
  throw std::invalid_argument("no check is named " + name);
}

} // namespace vkpt::test
