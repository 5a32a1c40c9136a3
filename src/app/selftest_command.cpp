#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/environment_file.h"
#include "app/expanded_options.h"
#include "app/interrupt.h"
#include "app/selftest_options.h"
#include "app/selftest_report.h"
#include "app/status_line.h"
#include "core/clock.h"
#include "selftest/run_tests.h"
#include "selftest/scene_means.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <optional>

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

ExitCode runFile(const RenderOptions& o) {
  const NoriTests tests = loadTests(o);
  const bool quiet = o.log == LogLevel::Quiet;
  std::optional<gpu::Context> context; // opened only where a scene is to be rendered
  const TestScenes testScenes = [&](const NoriTTest& test, std::uint32_t seed, const TellOutcome& tell) {
    if (!context)
      context.emplace(gpu::ContextOptions{o.device, o.validation, pipelineCacheFolder()});
    testSceneMeans(
        test, *context, [&o](const Scene& scene) { return estimatorFor(o, scene); }, seed, tell);
  };
  const SelftestCounts counts = runTests(tests, o.seed, testScenes, [quiet](const TestOutcome& outcome) {
    if (!quiet)
      fmt::print("{}\n", outcomeText(outcome));
  });
  if (!quiet)
    fmt::print("{} passed, {} failed (seed {})\n", counts.passed, counts.failed, o.seed);
  if (context && context->validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  if (counts.failed == 0)
    return ExitCode::Done;
  spdlog::error("{}: {} of {} tests failed (seed {})", o.scenes.front().string(), counts.failed,
                counts.passed + counts.failed, o.seed);
  return ExitCode::Comparison;
}

std::vector<selftest::Case> chosenCases(const SelftestOptions& o) {
  if (o.cases.empty())
    return selftest::allCases();
  std::vector<selftest::Case> cases;
  for (const std::string& name : o.cases)
    cases.push_back(*selftest::findCase(name));
  return cases;
}

/// Stops between two cases when a signal asks for it.
SelftestReport runCases(const SelftestOptions& o, const std::vector<selftest::Case>& cases) {
  const RenderOptions& common = o.common;
  const bool table = !o.json && common.log != LogLevel::Quiet;
  const gpu::Context context({common.device, common.validation, pipelineCacheFolder()});
  SelftestReport report{context.info(), common.seed, 0.0, {}};
  if (table)
    fmt::print("{}, {}\n{}", report.device.name, report.device.driver, caseTableHead());
  const Stopwatch watch;
  StatusLine progress(common.progress);
  for (const selftest::Case& c : cases) {
    if (InterruptGuard::requested())
      break;
    if (progress.onTerminal() || progress.isDue())
      progress.draw(fmt::format("case {} of {}: {}, {:.0f} s", report.results.size() + 1, cases.size(),
                                c.name, watch.seconds()));
    report.results.push_back(selftest::runCase(c, context, {}, common.seed));
    progress.clear();
    if (table)
      fmt::print("{}", caseTableRows(report.results.back(), common.log == LogLevel::Verbose));
    std::fflush(stdout);
    if (!o.keep.empty())
      selftest::keepPictures(report.results.back(), o.keep);
  }
  report.seconds = watch.seconds();
  return report;
}

ExitCode runHardCases(const SelftestOptions& o) {
  const std::vector<selftest::Case> cases = chosenCases(o);
  const InterruptGuard guard;
  const SelftestReport report = runCases(o, cases);
  const std::size_t failed = report.failed();
  if (o.json)
    fmt::print("{}", selftestJson(report));
  else if (o.common.log != LogLevel::Quiet)
    fmt::print("{} of {} cases passed in {:.1f} s (seed {})\n", report.results.size() - failed,
               report.results.size(), report.seconds, report.seed);
  if (report.results.size() < cases.size()) {
    spdlog::warn("interrupted: {} of {} cases were not run", cases.size() - report.results.size(),
                 cases.size());
    return ExitCode::Interrupted;
  }
  if (failed == 0)
    return ExitCode::Done;
  spdlog::error("{} of {} cases failed on {}; each alone: vkpt selftest --case NAME --verbose --keep DIR",
                failed, cases.size(), report.device.name);
  return ExitCode::Comparison;
}

} // namespace

ExitCode runSelftest(const std::vector<std::string>& arguments) {
  const std::optional<SelftestOptions> o = parseSelftestOptions(arguments);
  if (!o)
    return ExitCode::Done;
  setUpLog(o->common.log);
  if (o->list) {
    fmt::print("{}", caseList());
    return ExitCode::Done;
  }
  return o->file.empty() ? runHardCases(*o) : runFile(o->common);
}

} // namespace vkpt
