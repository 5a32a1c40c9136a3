#include "study/run_study.h"

#include "core/clock.h"
#include "render/render_loop.h"
#include "study/setting_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vkpt {
namespace {

constexpr std::uint32_t kReferenceSeed = 0x9E3779B9; // far from the seeds that count from the first one

/// How much of the study is done, in the seconds that it is planned to render.
class Schedule {
public:
  Schedule(const StudyPlan& plan, const StudyObserver& observer)
      : m_observer(observer), m_run(plan.seconds.value_or(1.0)),
        m_runs(static_cast<double>(plan.settings.size()) * plan.seeds),
        m_reference(plan.referenceImage ? 0.0 : kReferenceWork * m_run) {}

  bool compiling(const std::string& setting) { return tell(0.0, "compiling " + setting); }
  bool reference(double share) { return tell(share * m_reference, "reference"); }
  /// `runs`: finished ones and the shares of those under way.
  bool runs(double runs, const std::string& what) { return tell(m_reference + runs * m_run, what); }

private:
  bool tell(double done, const std::string& what) {
    const double all = m_reference + m_runs * m_run;
    const double share = std::clamp(done / all, 0.0, 1.0);
    const double left = share > 0.0 ? m_clock.seconds() * (1.0 / share - 1.0) : all;
    return m_observer({share, left, what});
  }

  const StudyObserver& m_observer;
  double m_run;
  double m_runs;
  double m_reference;
  Stopwatch m_clock;
};

class ReferenceObserver : public RenderObserver {
public:
  ReferenceObserver(Schedule& schedule, const RenderJob& job) : m_schedule(schedule), m_job(job) {}
  void onProgress(const RenderProgress& p) override {
    double share = 0.0;
    if (m_job.seconds)
      share = p.seconds / *m_job.seconds;
    if (m_job.frames)
      share = std::max(share, p.frames / static_cast<double>(*m_job.frames));
    m_goOn = m_schedule.reference(share);
  }
  bool stopRequested() override { return !m_goOn; }

private:
  Schedule& m_schedule;
  const RenderJob& m_job;
  bool m_goOn = true;
};

RenderJob referenceJob(const StudyPlan& plan) {
  RenderJob job;
  if (plan.frames)
    job.frames = static_cast<std::uint64_t>(kReferenceWork) * *plan.frames;
  if (plan.seconds)
    job.seconds = kReferenceWork * *plan.seconds;
  return job;
}

/// The runs of one study.
class Study {
public:
  Study(const gpu::Context& context, const Scene& scene, const StudyPlan& plan, const StudyObserver& observer)
      : m_context(context), m_scene(scene), m_plan(plan), m_schedule(plan, observer),
        m_secondLimit(plan.seconds) {}

  StudyResult run() {
    m_result.ablation = m_plan.ablation;
    m_result.targetError = m_plan.targetError;
    for (const StudySetting& setting : m_plan.settings) {
      m_schedule.compiling(setting.name);
      m_runs.emplace_back(m_context, m_scene, setting);
      m_result.settings.push_back({setting, {}, m_runs.back().compileSeconds(), {}, 0});
    }
    const Stopwatch watch;
    makeReference();
    for (std::uint32_t i = 0; i < m_plan.seeds && m_result.stop != StudyStop::User; ++i)
      runSeed(i);
    for (std::size_t i = 0; i < m_runs.size(); ++i)
      m_result.settings[i].faults = m_runs[i].faults();
    m_result.overheadSeconds =
        watch.seconds() - m_referenceCompileSeconds - m_result.referenceSeconds - m_result.renderSeconds;
    findCommonGround();
    return std::move(m_result);
  }

private:
  void makeReference() {
    if (m_plan.referenceImage) {
      m_reference.emplace(*m_plan.referenceImage);
    } else {
      SettingRun run(m_context, m_scene, m_plan.reference);
      m_referenceCompileSeconds = run.compileSeconds();
      run.restart(m_plan.firstSeed ^ kReferenceSeed);
      const RenderJob job = referenceJob(m_plan);
      ReferenceObserver observer(m_schedule, job);
      Film film;
      const RenderResult done = renderUntil(run.integrator(), film, job, observer);
      if (done.stop == StopReason::User)
        m_result.stop = StudyStop::User;
      m_result.referenceFrames = done.frames;
      m_result.referenceSeconds = done.seconds;
      m_reference.emplace(film);
    }
    m_result.referenceImage = m_reference->image();
    m_result.referenceMean = m_reference->mean();
    m_result.referenceMeanError = m_reference->standardError();
    m_result.referenceNoise = m_reference->noise();
    m_result.referenceNoiseIsKnown = m_reference->noiseIsKnown();
  }

  void runSeed(std::uint32_t index) {
    m_reached.assign(m_runs.size(), false);
    for (std::size_t i = 0; i < m_runs.size(); ++i) {
      const std::uint32_t seed = m_plan.firstSeed + index;
      m_runs[i].restart(seed);
      m_result.settings[i].runs.push_back({seed, {}, {}, {}});
    }
    while (const auto i = nextRun()) {
      SettingRun& run = m_runs[*i];
      const double before = run.seconds();
      run.step(m_plan.frames, m_secondLimit);
      m_result.renderSeconds += run.seconds() - before;
      if (run.isLookDue() || isFinished(*i))
        look(*i);
      const std::string what = fmt::format("seed {} of {}, {}: {} frames", index + 1, m_plan.seeds,
                                           m_plan.settings[*i].name, run.frames());
      if (!m_schedule.runs(static_cast<double>(index) * static_cast<double>(m_runs.size()) + sharesDone(),
                           what)) {
        m_result.stop = StudyStop::User;
        break;
      }
    }
    for (std::size_t i = 0; i < m_runs.size(); ++i)
      conclude(i, index == 0);
  }

  [[nodiscard]] bool isFinished(std::size_t i) const {
    return m_reached[i] || m_runs[i].finished(m_plan.frames, m_secondLimit);
  }

  /// The unfinished run with the least time.
  [[nodiscard]] std::optional<std::size_t> nextRun() const {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < m_runs.size(); ++i) {
      if (!isFinished(i) && (!next || m_runs[i].seconds() < m_runs[*next].seconds()))
        next = i;
    }
    return next;
  }

  [[nodiscard]] double sharesDone() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < m_runs.size(); ++i) {
      const SettingRun& run = m_runs[i];
      double share = m_reached[i] ? 1.0 : 0.0;
      if (m_secondLimit)
        share = std::max(share, run.seconds() / *m_secondLimit);
      if (m_plan.frames)
        share = std::max(share, static_cast<double>(run.frames()) / static_cast<double>(*m_plan.frames));
      sum += std::min(share, 1.0);
    }
    return sum;
  }

  void look(std::size_t i) {
    const Stopwatch watch;
    const SettingRun& run = m_runs[i];
    auto& points = m_result.settings[i].runs.back().points;
    if (run.frames() == 0 || (!points.empty() && points.back().frames == run.frames()))
      return;
    const Film film = run.film();
    const SquaredError measured = m_reference->measure(film);
    const SquaredError& noise = m_reference->noise();
    points.push_back({run.frames(),
                      run.seconds(),
                      {measured.mse - noise.mse, measured.relMse - noise.relMse},
                      m_reference->predict(film).relMse});
    if (m_plan.targetError && points.back().error.relMse <= *m_plan.targetError * *m_plan.targetError)
      m_reached[i] = true;
    if (!m_plan.ablation && noise.relMse > kMostReferenceNoise * measured.relMse) {
      m_result.stop = StudyStop::ReferenceNoise;
      m_secondLimit = std::min(run.seconds(), m_secondLimit.value_or(run.seconds()));
    }
    m_result.measuringSeconds += watch.seconds();
  }

  void conclude(std::size_t i, bool keepsPicture) {
    look(i);
    const Film film = m_runs[i].film();
    const FilmStatistics statistics = filmStatistics(film);
    StudyRun& run = m_result.settings[i].runs.back();
    run.mean = statistics.mean;
    run.standardError = statistics.standardError;
    if (keepsPicture)
      m_result.settings[i].picture = develop(film, {false});
    if (run.points.empty()) // broken off before its first frame
      m_result.settings[i].runs.pop_back();
  }

  /// Time and frames that every run has reached.
  void findCommonGround() {
    bool first = true;
    std::set<std::uint64_t> frames;
    for (const SettingResult& setting : m_result.settings) {
      for (const StudyRun& run : setting.runs) {
        std::set<std::uint64_t> own;
        for (const StudyPoint& p : run.points)
          own.insert(p.frames);
        if (first) {
          m_result.equalSeconds = run.points.back().seconds;
          frames = own;
        }
        m_result.equalSeconds = std::min(m_result.equalSeconds, run.points.back().seconds);
        std::erase_if(frames, [&own](std::uint64_t f) { return !own.contains(f); });
        first = false;
      }
    }
    m_result.equalFrames = frames.empty() ? 0 : *frames.rbegin();
  }

  const gpu::Context& m_context;
  const Scene& m_scene;
  const StudyPlan& m_plan;
  Schedule m_schedule;
  std::optional<double> m_secondLimit;
  std::vector<SettingRun> m_runs;
  std::vector<bool> m_reached; ///< the target error, in this seed
  std::optional<Reference> m_reference;
  double m_referenceCompileSeconds = 0.0;
  StudyResult m_result;
};

} // namespace

StudyResult runStudy(const gpu::Context& context, const Scene& scene, const StudyPlan& plan,
                     const StudyObserver& observer) {
  return Study(context, scene, plan, observer).run();
}

} // namespace vkpt
