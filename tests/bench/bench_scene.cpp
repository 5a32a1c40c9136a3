#include "bench_scene.h"

#include "host/learn_guide.h"
#include "yardstick.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vkpt::bench {
namespace {

float largestCoordinate(const Scene& scene) {
  float largest = 0.0F;
  for (const Vec3f& p : scene.positions)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

} // namespace

DeviceBench::DeviceBench(const gpu::Context& context, std::string name, Scene scene)
    : m_context(context), m_name(std::move(name)),
      m_scene(std::move(scene)), m_settings{{}, m_scene.width, m_scene.height, 0},
      m_effects(detectEffects(m_scene, m_settings.estimator)),
      m_packed(packGuided(m_scene, m_settings.estimator, m_effects)),
      m_deviceScene(uploadScene(context, m_packed)),
      m_integrator(context, m_deviceScene, m_scene, m_effects,
                   {m_settings.estimator, m_scene.width, m_scene.height, m_settings.seed, {}, {}}) {
  m_integrator.warmUp();
}

std::uint64_t DeviceBench::samplesPerRun(std::uint64_t frames) const {
  return frames * static_cast<std::uint64_t>(m_settings.width) *
         static_cast<std::uint64_t>(m_settings.height);
}

double DeviceBench::render(std::uint64_t frames) {
  m_integrator.clear();
  RenderJob job;
  job.frames = frames;
  RenderObserver observer;
  return renderUntil(m_integrator, m_film, job, observer).seconds;
}

SceneBench::SceneBench(const gpu::Context& context, std::string sceneName, Scene scene)
    : DeviceBench(context, std::move(sceneName), std::move(scene)), m_embree(m_packed) {
  RaySet set = recordRays(m_packed, m_embree, m_scene, m_effects, m_settings);
  const auto add = [&](const char* name, bool shadow, std::vector<RecordedRay>& rays) {
    m_rays.push_back(std::make_unique<RayBench>(context, m_deviceScene, name, shadow, std::move(rays),
                                                largestCoordinate(m_scene)));
  };
  add("primary", false, set.primary);
  add("bounce", false, set.bounce);
  add("shadow", true, set.shadow);
}

void SceneBench::renderYardstick(std::uint64_t frames) {
  m_yardstick = bench::renderYardstick(m_packed, m_embree, m_scene, m_effects, m_settings, frames);
}

std::string SceneBench::disagreement() const {
  const FilmStatistics ours = filmStatistics(m_film);
  const FilmStatistics theirs = filmStatistics(m_yardstick.film);
  for (int c = 0; c < 3; ++c) {
    // Independent renders would differ by sqrt(2) standard errors; these share their paths.
    if (!(std::abs(ours.mean[c] - theirs.mean[c]) <= ours.standardError[c])) {
      return fmt::format("{}: mean of channel {} is {} by vkpt, {} by the yardstick, standard error {}",
                         m_name, c, ours.mean[c], theirs.mean[c], ours.standardError[c]);
    }
  }
  return {};
}

SceneBench::RayBench::RayBench(const gpu::Context& context, const DeviceScene& scene, std::string rayName,
                               bool isShadow, std::vector<RecordedRay> recorded, float largest)
    : name(std::move(rayName)), shadow(isShadow), rays(std::move(recorded)),
      probe(context, scene, rays, shadow), embreeResults(rays.size()),
      rounding(16.0F * std::numeric_limits<float>::epsilon() * largest) {}

void SceneBench::RayBench::runEmbree(const EmbreeScene& embree) {
  if (shadow)
    embree.occluded(rays, embreeResults);
  else
    embree.closest(rays, embreeResults);
}

double SceneBench::RayBench::disagreement() const {
  const std::vector<float> ours = probe.results();
  std::size_t different = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const float theirs = std::min(embreeResults[i], 1e30F);
    if (!(std::abs(ours[i] - theirs) <= 1e-4F * theirs + rounding))
      ++different;
  }
  return static_cast<double>(different) / static_cast<double>(ours.size());
}

} // namespace vkpt::bench
