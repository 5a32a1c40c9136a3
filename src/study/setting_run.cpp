#include "study/setting_run.h"

#include "core/clock.h"
#include "host/learn_guide.h"
#include "render/render_job.h"

#include <algorithm>
#include <bit>

namespace vkpt {
SettingRun::SettingRun(const gpu::Context& context, const Scene& scene, const StudySetting& setting)
    : m_scene(scene), m_batch(setting.batch) {
  const Stopwatch watch;
  m_scene.filter = setting.filter;
  m_deviceScene = uploadScene(context, packGuided(m_scene, setting.estimator, setting.effects));
  m_integrator = std::make_unique<Integrator>(
      context, m_deviceScene, m_scene, setting.effects,
      IntegratorSettings{setting.estimator, m_scene.width, m_scene.height, 0, {}, {}});
  m_integrator->warmUp();
  m_compileSeconds = watch.seconds();
}

void SettingRun::restart(std::uint32_t seed) {
  m_integrator->restart(seed);
  m_frames = 0;
  m_seconds = 0.0;
}

bool SettingRun::finished(const std::optional<std::uint64_t>& frameLimit,
                          const std::optional<double>& secondLimit) const {
  if (m_frames == 0)
    return false;
  if (frameLimit && m_frames >= *frameLimit)
    return true;
  const double frame = m_seconds / static_cast<double>(m_frames);
  return secondLimit && *secondLimit - m_seconds < 0.5 * frame;
}

bool SettingRun::isLookDue() const { return std::has_single_bit(m_frames); }

void SettingRun::step(const std::optional<std::uint64_t>& frameLimit,
                      const std::optional<double>& secondLimit) {
  const std::uint64_t toGroupEnd = shared::kSamplesPerGroup - m_frames % shared::kSamplesPerGroup;
  std::uint64_t count = std::min<std::uint64_t>(m_batch, toGroupEnd);
  count = std::min(count, std::bit_ceil(m_frames + 1) - m_frames);
  if (frameLimit)
    count = std::min(count, *frameLimit - m_frames);
  if (secondLimit && m_seconds > 0.0) {
    const double left = (*secondLimit - m_seconds) * static_cast<double>(m_frames) / m_seconds;
    count = std::min(count, static_cast<std::uint64_t>(std::max(1.0, left + 0.5)));
  }
  const std::uint32_t blocks = m_integrator->blockCount();
  for (std::uint32_t first = 0; first < blocks;) {
    const std::uint64_t wanted = m_sizer.next() / (shared::kBlockPixels * count);
    const auto most = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(wanted, 1, kMostTileBlocks));
    const Tile tile{first, std::min(most, blocks - first)};
    const Stopwatch watch;
    const std::uint64_t samples = m_integrator->renderTile(tile, m_frames, static_cast<std::uint32_t>(count));
    const double seconds = watch.seconds();
    m_sizer.measured(samples, seconds);
    m_seconds += seconds;
    first += tile.blockCount;
  }
  m_frames += count;
}

} // namespace vkpt
