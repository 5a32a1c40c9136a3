#include "app/study_run.h"

#include "app/expanded_options.h"
#include "app/load_scene.h"
#include "core/clock.h"
#include "scene/image_size.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cctype>

namespace vkpt {
namespace {

constexpr int kLongerSide = 256; // pixels

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
    scaleImage(scene, static_cast<double>(kLongerSide) / std::max(scene.width, scene.height));
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
  setting.bias = biasOf(o, setting.estimator);
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
/// is hopeless for; independent samples, one light sample, paths from
/// the lights and guided directions where there are caustics, several paths behind specular surfaces, no
/// splitting, roulette by throughput; a seed of its own. What the settings have in common (bounces, kinds of
/// path, filter) it has too, since it decides what the image is. Multiple importance sampling is a trick that
/// settings may share with it: the price of a reference without it would be noise that decides for all of
/// them, where a lamp is small. Unbiased it is all the same, and its samples are its own.
StudySetting referenceSetting(const StudyOptions& o, const Scene& scene) {
  RenderOptions options = o.common;
  options.light = LightStrategy::Mis;
  options.estimator.sampler = Sampler::Independent;
  options.estimator.lightSelection = LightSelection::Auto;
  options.estimator.lightTracing = LightTracing::Auto;
  options.estimator.guiding = Guiding::Auto;
  options.estimator.specularSamples = kSpecularSamples;
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
  for (StudySetting& setting : plan.settings) // what the reference has too is no bias here
    std::erase_if(setting.bias, [&](const std::string& name) {
      return std::ranges::find(plan.reference.bias, name) != plan.reference.bias.end();
    });
  plan.referenceImage = std::move(reference);
  plan.seeds = o.seeds;
  plan.firstSeed = o.common.seed;
  plan.seconds = o.seconds;
  plan.frames = o.common.job.frames;
  plan.targetError = o.common.job.targetError;
  return plan;
}

std::string referenceName(const StudyOptions& o, const StudyResult& result) {
  if (!o.reference.empty())
    return o.reference.string();
  return fmt::format("rendered first with a seed of its own: independent samples, MIS, one light sample, no "
                     "splitting, roulette by "
                     "throughput, {:.6g} samples a pixel",
                     result.referenceFrames);
}

/// Of a scene's name: letters, digits and '-' stay.
std::string folderName(std::size_t number, const std::string& scene) {
  std::string name = fmt::format("{}-", number);
  for (const char c : scene)
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
  return name;
}

} // namespace

std::vector<LoadedStudy> loadStudies(const StudyOptions& o) {
  std::optional<Image> reference;
  if (!o.reference.empty())
    reference = readImage(o.reference);
  std::vector<LoadedStudy> studies;
  for (const auto& files : o.scenes) {
    const Stopwatch watch;
    RenderOptions options = o.common;
    options.scenes = files;
    SceneReport report;
    LoadedStudy study;
    study.scene = loadSceneFor(options, report);
    chooseSize(study.scene, o, reference);
    study.plan = planFor(o, study.scene, reference);
    study.folder = folderName(studies.size() + 1, study.scene.name);
    study.loadSeconds = watch.seconds();
    for (const auto& line :
         describeOptions(options, options.job, study.scene, study.plan.settings.front().estimator))
      spdlog::debug("{}", line);
    studies.push_back(std::move(study));
  }
  return studies;
}

StudySection runLoaded(const StudyOptions& o, const LoadedStudy& loaded, const gpu::Context& context,
                       const StudyObserver& observer) {
  StudySection section;
  section.result = runStudy(context, loaded.scene, loaded.plan, observer);
  StudyFacts& facts = section.facts;
  facts.command = o.command;
  facts.scene = loaded.scene.name;
  facts.folder = loaded.folder;
  facts.device = context.info().name;
  facts.kinds = o.kindName;
  facts.referenceName = referenceName(o, section.result);
  facts.loadSeconds = loaded.loadSeconds;
  for (const SettingResult& setting : section.result.settings)
    facts.compileSeconds += setting.compileSeconds;
  facts.display = o.common.display;
  return section;
}

ExitCode exitCodeOf(const StudyResult& result) {
  if (result.stop == StudyStop::User)
    return ExitCode::Interrupted;
  const bool faulty = std::ranges::any_of(result.settings, [](const auto& s) { return s.faults > 0; });
  return faulty ? ExitCode::Faults : ExitCode::Done;
}

} // namespace vkpt
