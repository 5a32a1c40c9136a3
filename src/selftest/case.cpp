#include "selftest/case.h"

#include "core/clock.h"
#include "film/image.h"

#include <fmt/format.h>

#include <algorithm>

namespace vkpt::selftest {

std::vector<Case> allCases() {
  std::vector<Case> cases;
  for (const auto& group :
       {driverCases(), watertightCases(), shapeCases(), rayCases(), oracleCases(), formulaCases(),
        smoothCases(), phongCases(), pathCases(), sumCases(), randomCases(), imageCases()})
    cases.insert(cases.end(), group.begin(), group.end());
  return cases;
}

const Case* findCase(std::string_view name) {
  static const std::vector<Case> cases = allCases();
  const auto found = std::ranges::find(cases, name, [](const Case& c) { return std::string_view(c.name); });
  return found == cases.end() ? nullptr : &*found;
}

CaseResult runCase(const Case& which, const gpu::Context& context, const Kernel& kernel, std::uint32_t seed) {
  Trial trial(which.name, context, kernel, seed);
  const std::uint64_t messages = context.validationMessages();
  const Stopwatch watch;
  try {
    trial.run(which.run);
  } catch (const std::exception& e) {
    trial.expect(false, e.what());
  }
  trial.expect(context.validationMessages() == messages, "the Vulkan validation layer had something to say");
  return {which, watch.seconds(), trial.figures(), trial.failures(), trial.conditions(), trial.pictures()};
}

void keepPictures(const CaseResult& result, const fs::path& folder) {
  fs::create_directories(folder);
  for (std::size_t i = 0; i < result.pictures.size(); ++i) {
    for (const char* extension : {".exr", ".png"}) {
      const fs::path file = folder / fmt::format("{}-{}{}", result.which.name, i, extension);
      writeImage(file.string(), develop(result.pictures[i]), {}, {});
    }
  }
}

} // namespace vkpt::selftest
