// The default command: load, build, compile, render, write.

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/pilot_run.h"
#include "app/progress.h"
#include "app/render_run.h"
#include "core/clock.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace vkpt {
namespace {

ExitCode conclude(const RenderOptions& o, const RunReport& report, const gpu::Context& context) {
  if (o.log != LogLevel::Quiet)
    fmt::print("{}", summaryText(report, o.outputs));
  if (context.validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  if (report.counters.faults() > 0) {
    spdlog::error("{}: {}; the image is wrong there", report.scene, faultText(report.counters));
    return ExitCode::Faults;
  }
  return report.result.stop == StopReason::User ? ExitCode::Interrupted : ExitCode::Done;
}

} // namespace

ExitCode runRender(const RenderOptions& asked) {
  checkOutputs(asked);
  const InterruptGuard interrupts;
  PreparedRun prepared = prepareRun(asked);
  const gpu::Context context({asked.device, asked.validation, pipelineCacheFolder()});
  const RenderOptions o = asked.pilotSeconds ? pilotRun(asked, prepared, context) : asked;
  FinishedRun run;
  {
    ProgressLine progress(o.progress);
    run = renderRun(o, prepared, context, progress);
  }
  const Stopwatch watch;
  writeImages(o, run.report, run.film, run.kinds);
  run.report.seconds.output = watch.seconds();
  writeStats(o, run.report);
  return conclude(o, run.report, context);
}

} // namespace vkpt
