// vkpt study: what accuracy costs in time.

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/expanded_options.h"
#include "app/interrupt.h"
#include "app/load_scene.h"
#include "app/status_line.h"
#include "app/study_options.h"
#include "core/clock.h"
#include "film/file_io.h"
#include "study/run_study.h"
#include "study/study_report.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

constexpr int kLongerSide = 256; // pixels

/// Before anything is loaded.
void checkFolder(const StudyOptions& o) {
  if (fs::exists(o.folder) && !fs::is_directory(o.folder))
    throw UsageError(fmt::format("--output '{}': expected a folder, and this is none", o.folder.string()));
  if (fs::is_directory(o.folder) && !fs::is_empty(o.folder) && !o.force)
    throw UsageError(fmt::format(
        "--output '{}': there are files in it; --force writes over those of a report", o.folder.string()));
}

/// Before anything is rendered.
void makeFolder(const StudyOptions& o) {
  std::error_code failure;
  fs::create_directories(o.folder, failure);
  if (failure)
    throw UsageError(fmt::format("--output '{}': {}", o.folder.string(), failure.message()));
  const film::AtomicFile trial(o.folder / "report.html"); // not committed: removed again
}

void chooseSize(Scene& scene, const StudyOptions& o, const std::optional<Image>& reference) {
  if (reference && o.common.size && std::pair(reference->width, reference->height) != *o.common.size)
    throw SceneError(
        {o.reference.string()},
        fmt::format("{}x{} pixels, but --size says {}x{}; leave --size out to take the reference's",
                    reference->width, reference->height, o.common.size->first, o.common.size->second));
  if (reference) {
    scene.width = reference->width;
    scene.height = reference->height;
  } else if (!o.common.size) {
    const double scale = static_cast<double>(kLongerSide) / std::max(scene.width, scene.height);
    scene.width = std::max(1, static_cast<int>(std::lround(scene.width * scale)));
    scene.height = std::max(1, static_cast<int>(std::lround(scene.height * scale)));
  }
}

StudySetting settingFor(const std::string& name, const RenderOptions& o, const StudyOptions& study,
                        const Scene& scene) {
  StudySetting setting;
  setting.name = name;
  setting.estimator = estimatorFor(o, scene);
  if (study.pathKinds)
    setting.estimator.pathKinds = *study.pathKinds;
  Scene filtered = scene;
  if (o.filter && *o.filter != scene.filter.shape)
    filtered.filter = namedFilter(*o.filter);
  setting.filter = filtered.filter;
  setting.effects = compiledEffects(o.effects, detectEffects(filtered, setting.estimator));
  setting.batch = o.job.batch;
  return setting;
}

/// What a scene's own look is made of. Leaving out what makes up the estimator instead would leave its image
/// as it is, or make it wrong.
constexpr Effect kSurfaces[] = {
    Effect::Diffuse,       Effect::Mirror,     Effect::Glass,      Effect::Metal,    Effect::Phong,
    Effect::Microfacet,    Effect::RoughMetal, Effect::RoughGlass, Effect::Textures, Effect::Absorption,
    Effect::SmoothNormals, Effect::Background, Effect::OneSided};

/// The whole, then without each kind of light path and each effect that it has.
std::vector<StudySetting> ablations(const StudySetting& whole, const Scene& scene) {
  std::vector<StudySetting> settings{whole};
  settings.front().name = "whole";
  for (std::uint32_t i = 0; i < kPathKindCount; ++i) {
    const std::uint32_t bit = 1U << i;
    if ((whole.estimator.pathKinds & ~bit) == 0 || (whole.estimator.pathKinds & bit) == 0)
      continue;
    StudySetting s = whole;
    s.name = fmt::format("without {} paths", pathKindName(static_cast<PathKind>(i)));
    s.estimator.pathKinds &= ~bit;
    s.effects = detectEffects(scene, s.estimator);
    settings.push_back(std::move(s));
  }
  for (const Effect effect : kSurfaces) {
    if (!whole.effects.has(effect))
      continue;
    StudySetting s = whole;
    s.name = fmt::format("without {}", effectName(effect));
    EffectSet leftOut;
    leftOut.set(effect);
    s.effects = without(whole.effects, leftOut);
    settings.push_back(std::move(s));
  }
  return settings;
}

/// By the estimator that every setting is to agree with: both strategies for lights, weighted, which no scene
/// is hopeless for; one light sample, no splitting, roulette by throughput; a seed of its own. What the
/// settings have in common (bounces, kinds of path, filter) it has too, since it decides what the image is.
/// Multiple importance sampling is a trick that settings may share with it: the price of a reference without
/// it would be noise that decides for all of them, where a lamp is small. Unbiased it is all the same, and
/// its samples are its own.
StudySetting referenceSetting(const StudyOptions& o, const Scene& scene) {
  RenderOptions options = o.common;
  options.light = LightStrategy::Mis;
  options.estimator.lightSamples = 1;
  options.estimator.splitDepth = 0;
  options.estimator.roulette = RouletteMode::Throughput;
  options.estimator.rouletteAfter.reset();
  options.effects = {};
  return settingFor("reference", options, o, scene);
}

StudyPlan planFor(const StudyOptions& o, const Scene& scene, std::optional<Image> reference) {
  StudyPlan plan;
  for (const StudyVariant& variant : o.variants)
    plan.settings.push_back(settingFor(variant.name, variant.options, o, scene));
  plan.ablation = o.ablate;
  if (o.ablate)
    plan.settings = ablations(plan.settings.front(), scene);
  plan.reference = referenceSetting(o, scene);
  plan.referenceImage = std::move(reference);
  plan.seeds = o.seeds;
  plan.firstSeed = o.common.seed;
  plan.seconds = o.seconds;
  plan.frames = o.common.job.frames;
  return plan;
}

std::string ablationText(const std::vector<SettingSummary>& summaries, std::size_t width) {
  std::string text = fmt::format("{:<{}}  time saved  energy lost\n", "left out", width);
  for (std::size_t i = 1; i < summaries.size(); ++i) {
    const Ablation a = ablationOf(summaries.front(), summaries[i]);
    text += fmt::format("{:<{}}  {:>8.1f} %  {:>9.2f} %\n", summaries[i].name, width, a.timeSaved * 100.0,
                        a.energyLost * 100.0);
  }
  return text;
}

std::string errorText(const std::vector<SettingSummary>& summaries, std::size_t width, double seconds) {
  const auto slope = [](const std::optional<Estimate>& e) {
    if (!e)
      return std::string("-");
    return fmt::format("{:.2f}", e->value) +
           (e->standardError ? fmt::format(" ± {:.2f}", *e->standardError) : std::string());
  };
  std::string text = fmt::format("{:<{}}  error after {:.3g} s  efficiency  slope over time    energy\n",
                                 "setting", width, seconds);
  for (const auto& s : summaries) {
    const std::string error =
        s.errorAtEqualTime ? fmt::format("{:.3g} %", s.errorAtEqualTime->median * 100.0) : "-";
    text += fmt::format("{:<{}}  {:>18}  {:>10}  {:>15}  {:>+6.2f} %\n", s.name, width, error,
                        s.efficiency ? fmt::format("{:.3g}", *s.efficiency) : "-", slope(s.slopeOverTime),
                        s.energy.value * 100.0);
  }
  return text;
}

std::string summaryText(const StudyOptions& o, const StudyResult& result) {
  const auto summaries = summarise(result);
  std::size_t width = 8;
  for (const auto& s : summaries)
    width = std::max(width, s.name.size());
  std::string text =
      result.ablation ? ablationText(summaries, width) : errorText(summaries, width, result.equalSeconds);
  for (const auto& remark : remarks(result, summaries))
    text += remark + "\n";
  return text + fmt::format("written: {}\n", (o.folder / "report.html").string());
}

std::string referenceName(const StudyOptions& o, const StudyResult& result) {
  if (!o.reference.empty())
    return o.reference.string();
  return fmt::format(
      "rendered first with a seed of its own: MIS, one light sample, no splitting, roulette by "
      "throughput, {:.6g} samples a pixel",
      result.referenceFrames);
}

ExitCode exitCodeOf(const StudyResult& result) {
  if (result.stop == StudyStop::User)
    return ExitCode::Interrupted;
  const bool faulty = std::ranges::any_of(result.settings, [](const auto& s) { return s.faults > 0; });
  return faulty ? ExitCode::Faults : ExitCode::Done;
}

} // namespace

ExitCode runStudy(const std::vector<std::string>& arguments) {
  const auto o = parseStudyOptions(arguments);
  if (!o)
    return ExitCode::Done;
  setUpLog(o->common.log);
  checkGnuplot();
  checkFolder(*o);
  const InterruptGuard interrupts;
  const Stopwatch watch;

  std::optional<Image> reference;
  if (!o->reference.empty())
    reference = readImage(o->reference);
  SceneReport sceneReport;
  Scene scene = loadSceneFor(o->common, sceneReport);
  chooseSize(scene, *o, reference);
  const gpu::Context context({o->common.device, o->common.validation, pipelineCacheFolder()});
  StudyFacts facts{o->command,      scene.name, context.info().name, o->kindName, {},
                   watch.seconds(), 0.0,        o->common.display};

  const StudyPlan plan = planFor(*o, scene, std::move(reference));
  for (const auto& line : describeOptions(o->common, o->common.job, scene, plan.settings.front().estimator))
    spdlog::debug("{}", line);

  makeFolder(*o);
  StudyResult result;
  {
    StatusLine line(o->common.progress);
    result = runStudy(context, scene, plan, [&](const StudyProgress& p) {
      if (line.isDue())
        line.draw(fmt::format("{:.0f} %, {:.0f} s left, {}", p.share * 100.0, p.secondsLeft, p.what));
      return !InterruptGuard::requested();
    });
  }
  for (const SettingResult& setting : result.settings)
    facts.compileSeconds += setting.compileSeconds;
  facts.referenceName = referenceName(*o, result);
  writeReport(o->folder, facts, result);
  if (o->common.log != LogLevel::Quiet)
    fmt::print("{}", summaryText(*o, result));
  if (context.validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  return exitCodeOf(result);
}

} // namespace vkpt
