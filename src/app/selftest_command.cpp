#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/environment_file.h"
#include "app/expanded_options.h"
#include "selftest/run_tests.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace vkpt {
namespace {

NoriTests loadTests(const RenderOptions& o) {
  SceneReport report;
  NoriTests tests = loadNoriTests(o.scenes.front(), report);
  for (const auto& warning : report.warnings) {
    if (o.strict)
      throw Error(ExitCode::Scene, warning + " (an error by --strict)");
    spdlog::warn("{}", warning);
  }
  for (const auto& note : report.notes)
    spdlog::debug("{}", note);
  for (NoriTTest& test : tests.tTests) {
    for (Scene& scene : test.scenes)
      readEnvironment(scene);
  }
  return tests;
}

} // namespace

ExitCode runSelftest(const RenderOptions& o) {
  const NoriTests tests = loadTests(o);
  const bool quiet = o.log == LogLevel::Quiet;
  const SelftestSettings settings{o.seed,
                                  [&o](const Scene& scene) { return estimatorFor(o, scene); },
                                  {o.device, o.validation, pipelineCacheFolder()}};
  const SelftestCounts counts = runTests(tests, settings, [quiet](const TestOutcome& outcome) {
    if (!quiet)
      fmt::print("{}\n", outcomeText(outcome));
  });
  if (!quiet)
    fmt::print("{} passed, {} failed (seed {})\n", counts.passed, counts.failed, o.seed);
  if (counts.validationMessages > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  if (counts.failed == 0)
    return ExitCode::Done;
  spdlog::error("{}: {} of {} tests failed (seed {})", o.scenes.front().string(), counts.failed,
                counts.passed + counts.failed, o.seed);
  return ExitCode::Comparison;
}

} // namespace vkpt
