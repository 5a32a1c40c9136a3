#include "render/render_loop.h"

#include "core/clock.h"
#include "render/dispatch_sizer.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <limits>

namespace vkpt {
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kFirstLook = 16;    // frames; a variance of fewer samples says little
constexpr std::uint64_t kLeastGrowth = 2;   // a growing batch adds at most half of the frames
constexpr double kMostOfTimeLooking = 0.01; // where no rule needs the looks

/// One run's state: what has been done, and what the rules say of it.
class Run {
public:
  Run(Integrator& integrator, const RenderJob& job, RenderObserver& observer)
      : m_integrator(integrator), m_job(job), m_observer(observer),
        m_pixels(static_cast<double>(integrator.settings().width) * integrator.settings().height),
        m_sizer(job.unitSeconds) {}

  /// Samples [m_frame, m_frame + batch) of every pixel, tile by tile. Returns the reason when a rule stops
  /// it.
  std::optional<StopReason> renderBatch() {
    const std::uint32_t batch = nextBatch();
    const std::uint32_t blocks = m_integrator.blockCount();
    for (std::uint32_t first = 0; first < blocks;) {
      const Tile tile{first, std::min(tileBlocks(batch), blocks - first)};
      Stopwatch watch;
      const std::uint64_t samples =
          m_integrator.renderTile(tile, m_frame, batch, [this] { m_observer.onDispatch(); });
      m_sizer.measured(samples, watch.seconds());
      first += tile.blockCount;
      m_frames = static_cast<double>(m_frame) + static_cast<double>(batch) * first / blocks;
      report();
      if (m_observer.stopRequested() && ends(StopReason::User))
        return StopReason::User;
      if (m_job.seconds && seconds() >= *m_job.seconds && ends(StopReason::Time))
        return StopReason::Time;
    }
    m_frame += batch;
    m_frames = static_cast<double>(m_frame);
    if (m_frame >= m_job.frames.value_or(kNoLimit) && ends(StopReason::Frames))
      return StopReason::Frames;
    takeLook();
    look();
    return errorReached() && ends(StopReason::Error) ? std::optional(StopReason::Error) : std::nullopt;
  }

  [[nodiscard]] RenderResult result(StopReason stop) const { return {stop, seconds(), m_frames, m_looks}; }

private:
  struct Look {
    Film film;
    FilmStatistics statistics;
    double frames = 0.0;
    double at = 0.0;   // seconds of rendering
    double took = 0.0; // seconds
  };

  /// Of rendering: what the observer took to let the run go on is left out.
  [[nodiscard]] double seconds() const { return m_clock.seconds() - m_heldSeconds; }

  bool ends(StopReason reason) {
    const Stopwatch held;
    const bool goesOn = m_observer.goesOn(reason);
    m_heldSeconds += held.seconds();
    return !goesOn;
  }

  /// Batches never straddle a group of samples.
  [[nodiscard]] std::uint32_t nextBatch() const {
    const std::uint64_t toGroupEnd = shared::kSamplesPerGroup - m_frame % shared::kSamplesPerGroup;
    const std::uint64_t most =
        m_job.growingBatch ? std::min<std::uint64_t>(m_job.batch, m_frame / kLeastGrowth) : m_job.batch;
    const std::uint64_t wanted = std::clamp<std::uint64_t>(most, 1, toGroupEnd);
    return static_cast<std::uint32_t>(std::min(wanted, m_job.frames.value_or(kNoLimit) - m_frame));
  }

  [[nodiscard]] std::uint32_t tileBlocks(std::uint32_t batch) const {
    if (m_job.tileBlocks > 0)
      return m_job.tileBlocks;
    const double left = m_job.seconds.value_or(1e9) - seconds();
    const std::uint64_t samples = m_sizer.nextWithin(left);
    return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(
        samples / (std::uint64_t{shared::kBlockPixels} * batch), 1, kMostTileBlocks));
  }

  /// The film is looked at when the number of frames has grown by a half: often enough, and at little cost.
  void look() {
    const bool afford = m_lookSeconds <= kMostOfTimeLooking * seconds();
    if (m_frame < m_nextLook || m_look.valid() || !(m_job.targetError || afford))
      return;
    m_nextLook = m_frame + std::max<std::uint64_t>(m_frame / 2, 1);
    const auto policy = m_job.looksAside ? std::launch::async : std::launch::deferred;
    const Stopwatch watch;
    m_look = std::async(policy, [raw = m_integrator.rawFilm(), frames = m_frames, at = seconds(), watch] {
      Look look{raw.film(), {}, frames, at, 0.0};
      look.statistics = filmStatistics(look.film);
      look.took = watch.seconds();
      return look;
    });
    if (!m_job.looksAside)
      takeLook();
  }

  /// What the look that is under way has found, if it has ended.
  void takeLook() {
    if (!m_look.valid() || m_look.wait_for(std::chrono::seconds(0)) == std::future_status::timeout)
      return;
    Look look = m_look.get();
    m_lookSeconds = look.took;
    m_error = look.statistics.relativeErrorUpper; // 95 % confident
    m_looks.push_back({look.frames, look.statistics.relativeError});
    m_lookedAt = look.at;
    m_observer.onLook(std::move(look.film), look.statistics);
  }

  [[nodiscard]] bool errorReached() const {
    return m_job.targetError && m_error && *m_error <= *m_job.targetError;
  }

  /// From the start to the target, along the slope that this run's looks have; nothing where it does not
  /// fall.
  [[nodiscard]] std::optional<double> secondsToTarget() const {
    if (!m_job.targetError || !m_error)
      return std::nullopt;
    const auto cost = costOfError(*m_job.targetError / *m_error, m_looks, m_lookedAt);
    return cost ? std::optional(m_lookedAt + cost->more) : std::nullopt;
  }

  void report() {
    RenderProgress p;
    p.frames = m_frames;
    p.seconds = seconds();
    p.samplesPerSecond = m_frames * m_pixels / std::max(p.seconds, 1e-9);
    p.relativeError = m_error;
    p.targetError = m_job.targetError;
    const auto sooner = [&](double seconds) {
      p.remainingSeconds = std::max(0.0, std::min(seconds, p.remainingSeconds.value_or(seconds)));
    };
    if (m_job.seconds)
      sooner(*m_job.seconds - p.seconds);
    if (m_job.frames)
      sooner(p.seconds * (static_cast<double>(*m_job.frames) / m_frames - 1.0));
    if (const auto seconds = secondsToTarget())
      sooner(*seconds - p.seconds);
    m_observer.onProgress(p);
  }

  Integrator& m_integrator;
  const RenderJob& m_job;
  RenderObserver& m_observer;
  double m_pixels;
  Stopwatch m_clock;
  double m_heldSeconds = 0.0;
  DispatchSizer m_sizer;
  std::uint64_t m_frame = 0; // finished for every pixel
  double m_frames = 0.0;
  std::uint64_t m_nextLook = kFirstLook;
  double m_lookSeconds = 0.0; // that the last look took
  std::future<Look> m_look;   // under way
  std::optional<double> m_error;
  std::vector<ErrorAtWork> m_looks;
  double m_lookedAt = 0.0; // seconds, the last time
};

} // namespace

const char* stopReasonName(StopReason reason) {
  switch (reason) {
  case StopReason::Frames:
    return "frames";
  case StopReason::Time:
    return "time";
  case StopReason::Error:
    return "error";
  case StopReason::User:
    return "user";
  case StopReason::Fault:
    return "fault";
  }
  return "";
}

RenderResult renderUntil(Integrator& integrator, const RenderJob& job, RenderObserver& observer) {
  Run run(integrator, job, observer);
  std::optional<StopReason> stop;
  while (!stop)
    stop = run.renderBatch();
  return run.result(*stop);
}

RenderResult renderUntil(Integrator& integrator, Film& film, const RenderJob& job, RenderObserver& observer) {
  RenderResult result = renderUntil(integrator, job, observer);
  film = integrator.film();
  if (result.looks.empty() || result.looks.back().work < result.frames)
    result.looks.push_back({result.frames, filmStatistics(film).relativeError});
  return result;
}

} // namespace vkpt
