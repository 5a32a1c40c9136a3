#include "app/view/session.h"

#include "app/expanded_options.h"
#include "app/interrupt.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

constexpr double kUnit = 0.020;           // s of a unit of work: the user is heard after each
constexpr double kUnheard = 0.012;        // s, then between the dispatches of a unit, too
constexpr double kLively = 1.0 / 40.0;    // s between pictures while the user does something
constexpr double kCalm = 1.0 / 4.0;       // and while he watches
constexpr double kMostOfTime = 0.1;       // for pictures, while he watches
constexpr double kCalmAfter = 1.0;        // s without input
constexpr double kStillAfter = 0.2;       // s without motion, then the film is as fine as the window
constexpr double kMovingFrame = 1.0 / 25; // s that a frame may take while the camera moves
constexpr double kMessageSeconds = 4.0;
constexpr double kRestWait = 0.25; // s; a resting window looks up that often
constexpr int kCoarsest = 8;

Box3d boxOf(const Scene& scene) {
  Box3d box;
  for (const Vec3f& p : scene.positions)
    box.extend(scene.origin + Vec3d(p));
  return box;
}

ViewSettings settingsFor(const SessionOptions& o, const PreparedRun& prepared) {
  ViewSettings s;
  s.estimator = prepared.estimator;
  s.estimator.kindImages = false;
  s.job = prepared.job;
  s.display = o.render.display;
  return s;
}

} // namespace

Session::Session(const SessionOptions& options, PreparedRun& prepared, const gpu::Context& context,
                 Window& window)
    : m_options(options), m_prepared(prepared), m_context(context), m_window(window),
      m_log(options.logEvents), m_stage(context, options.render, prepared.scene),
      m_presenter(context, window), m_rig(prepared.scene.camera, prepared.scene.camera.target),
      m_home(prepared.scene.camera), m_box(boxOf(prepared.scene)), m_settings(settingsFor(options, prepared)),
      m_begun(m_settings) {
  m_facts.device = context.info().name;
  m_facts.scene = prepared.scene.name;
  m_stage.prepare(m_settings);
}

ExitCode Session::run() {
  const InterruptGuard interrupts;
  while (!m_quit) {
    try {
      begin();
      renderUntil(m_stage.integrator(), m_job, *this);
    } catch (const DeviceError& e) {
      rescue(e.what());
      throw;
    }
  }
  return conclude();
}

int Session::coarsenessFor(bool moving) const {
  if (!moving)
    return 1;
  const double rate = m_facts.progress.samplesPerSecond;
  const double pixels = static_cast<double>(m_windowSize.x) * m_windowSize.y;
  int coarseness = rate > 0.0 ? 1 : kCoarsest / 2;
  while (rate > 0.0 && coarseness < kCoarsest && pixels / (coarseness * coarseness) > kMovingFrame * rate)
    coarseness *= 2;
  return coarseness;
}

void Session::begin() {
  m_faults += m_facts.counters.faults();
  m_presenter.finish(); // it may still draw the film that goes
  if (differInFilm(m_begun, m_settings))
    m_stage.prepare(m_settings);
  m_begun = m_settings;
  if (const Vec2i size = m_window.size(); size.x > 0 && size.y > 0)
    m_windowSize = size;
  m_facts.coarseness = coarsenessFor(!m_firstPicture || m_sinceMove.seconds() < kStillAfter);
  const int c = m_facts.coarseness;
  m_facts.filmSize = (m_windowSize + Vec2i(c - 1)) / c;
  m_stage.restart(m_rig.camera(), m_facts.filmSize);
  m_presenter.bind(m_stage.integrator());
  m_facts.effects = m_stage.effects().names();
  m_facts.bias = biasOf(m_options.render, m_stage.integrator().settings().estimator);
  m_facts.progress.frames = 0.0;
  m_facts.looks.clear();
  m_lastLook = {};
  m_facts.rests.reset();
  m_facts.counters = {};
  m_facts.pixel.reset();
  m_job = c == 1 ? m_settings.job : RenderJob();
  m_job.batch = m_options.render.job.batch;
  m_job.tileBlocks = m_options.render.job.tileBlocks;
  m_job.unitSeconds = kUnit;
  m_job.growingBatch = true;
  m_job.looksAside = true;
  m_moved = false;
  m_shown = false;
  m_log.write(
      "begun",
      {{"size", numbers(m_facts.filmSize)}, {"coarseness", c}, {"shader", shaderName(m_begun.shader)}});
}

// --- of the render loop ---

void Session::onProgress(const RenderProgress& progress) {
  const double before = m_facts.progress.frames;
  m_facts.progress = progress;
  m_facts.counters = m_stage.integrator().counters();
  if (std::floor(std::log2(progress.frames)) > std::floor(std::log2(std::max(before, 0.5))) &&
      m_facts.coarseness == 1)
    m_log.write("frames", {{"frames", progress.frames}, {"seconds", progress.seconds}});
  m_stale = true;
  tick(0.0);
}

void Session::onDispatch() {
  if (m_sinceHeard.seconds() > kUnheard)
    tick(0.0);
}

void Session::onLook(Film&& film, const FilmStatistics& statistics) {
  m_facts.looks.push_back({m_facts.progress.seconds, m_facts.progress.frames, statistics.relativeError});
  m_facts.progress.relativeError = statistics.relativeErrorUpper;
  m_lastLook = std::move(film);
}

bool Session::mustBegin() const {
  if (differInFilm(m_begun, m_settings))
    return true;
  // A coarse film is shown before the next one is begun, or fast motion would never show any.
  const bool coarse = m_facts.coarseness > 1;
  if (coarse && !m_shown)
    return false;
  return m_moved || (coarse && m_sinceMove.seconds() >= kStillAfter);
}

bool Session::stopRequested() { return m_quit || mustBegin() || m_settings.paused; }

bool Session::goesOn(StopReason reason) {
  const auto isMet = [&] {
    switch (reason) {
    case StopReason::Frames:
      return m_job.frames && m_facts.progress.frames >= static_cast<double>(*m_job.frames);
    case StopReason::Time:
      return m_job.seconds && m_facts.progress.seconds >= *m_job.seconds;
    case StopReason::Error:
      return m_job.targetError && m_facts.progress.relativeError.value_or(1e9) <= *m_job.targetError;
    default:
      return m_settings.paused;
    }
  };
  if (m_quit || mustBegin())
    return false;
  m_facts.rests = reason;
  m_stale = true;
  show();
  m_presenter.finish();
  m_log.write("rests", {{"reason", stopReasonName(reason)},
                        {"frames", m_facts.progress.frames},
                        {"seconds", m_facts.progress.seconds},
                        {"samplesPerSecond", m_facts.progress.samplesPerSecond}});
  if (m_options.close && reason != StopReason::User) {
    m_quit = true;
    return false;
  }
  while (isMet() && !m_quit && !mustBegin())
    tick(kRestWait);
  m_facts.rests.reset();
  m_log.write("goes on", {{"frames", m_facts.progress.frames}});
  return !m_quit && !mustBegin();
}

// --- the user ---

void Session::tick(double wait) {
  const double waited = m_sinceHeard.seconds();
  if (m_firstPicture)
    m_longestWait = std::max(m_longestWait, waited);
  m_window.poll(wait);
  hear();
  m_sinceHeard.restart();
  if (m_facts.coarseness == 1) { // the loop reads its rules anew each time
    m_job.frames = m_settings.job.frames;
    m_job.seconds = m_settings.job.seconds;
    m_job.targetError = m_settings.job.targetError;
  }
  if (isDue())
    show();
}

bool Session::isDue() const {
  const double since = m_sinceShown.seconds();
  if (!m_stale || since < kLively)
    return false;
  if (!m_shown && m_facts.progress.frames >= 1.0)
    return true;
  if (m_facts.coarseness > 1) // a torn picture is worse than none
    return false;
  return m_sinceInput.seconds() < kCalmAfter || since >= std::max(kCalm, m_showSeconds / kMostOfTime);
}

void Session::show() {
  const Stopwatch watch;
  if (m_sinceMessage.seconds() > kMessageSeconds)
    m_facts.message.clear();
  PanelRequests requests;
  const bool shown = m_presenter.show(m_facts.filmSize, m_settings.display, m_settings.shows,
                                      [&] { requests = drawPanel(m_facts, m_settings); });
  hearPanel(requests);
  m_showSeconds = watch.seconds();
  m_sinceShown.restart();
  // A window that was busy is tried again; widgets move, messages go.
  m_stale = !shown || !m_facts.message.empty() || m_sinceInput.seconds() < kCalmAfter;
  if (!shown)
    return;
  m_shown = m_shown || m_facts.progress.frames >= 1.0;
  if (!m_firstPicture && m_shown) {
    m_firstPicture = true;
    m_sinceMove.restart();
    m_log.write("first picture", {{"seconds", m_sinceStart.seconds()}});
  }
}

// --- files ---

ViewRun Session::viewRun(StopReason stop) const {
  ViewRun run{{stop, m_facts.progress.seconds, m_facts.progress.frames, {}}, m_begun, m_context.info().name};
  run.settings.display = m_settings.display;
  for (const ErrorLook& look : m_facts.looks)
    run.result.looks.push_back({look.frames, look.relative});
  return run;
}

void Session::save() {
  try {
    const auto paths =
        saveFilm(m_options.render, m_options.outputsNamed, m_prepared, m_stage,
                 viewRun(m_facts.rests.value_or(StopReason::User)), m_stage.integrator().film());
    nlohmann::json names = nlohmann::json::array();
    std::string text = "saved";
    for (const auto& path : paths) {
      names.push_back(path.string());
      text.append(" ").append(path.string());
    }
    say(text);
    spdlog::info("{}", text);
    m_log.write("saved", {{"files", names}, {"frames", m_facts.progress.frames}});
  } catch (const DeviceError&) {
    throw;
  } catch (const Error& e) {
    say(fmt::format("not saved: {}", e.what()));
    spdlog::error("not saved: {}", e.what());
  }
}

void Session::rescue(const std::string& error) {
  if (m_lastLook.pixels.empty())
    return;
  const ViewRun run = viewRun(StopReason::Fault);
  const auto paths = saveFilm(m_options.render, false, m_prepared, m_stage, run, m_lastLook);
  for (const auto& path : paths)
    spdlog::warn("{}; saved what was rendered as of the last look at it: {}", error, path.string());
}

ExitCode Session::conclude() {
  if (!m_options.render.stats.empty()) {
    const Film film = m_stage.integrator().film();
    const ViewRun run = viewRun(m_facts.rests.value_or(StopReason::User));
    writeStats(m_options.render, reportOf(m_options.render, m_prepared, m_stage, run, film));
  }
  m_faults += m_facts.counters.faults();
  m_log.write("ends", {{"frames", m_facts.progress.frames}, {"longestWait", m_longestWait}});
  if (m_context.validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  if (m_faults > 0) {
    spdlog::error("{}: {} faults were counted; the image was wrong there", m_facts.scene, m_faults);
    return ExitCode::Faults;
  }
  return InterruptGuard::requested() ? ExitCode::Interrupted : ExitCode::Done;
}

} // namespace vkpt
