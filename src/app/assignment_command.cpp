// vkpt assignment a|b: pictures, experiments, and a page with the answers.

#include "app/assets_folder.h"
#include "app/assignment_options.h"
#include "app/assignment_results.h"
#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/output_folder.h"
#include "app/render_run.h"
#include "app/study_run.h"
#include "app/work_line.h"
#include "film/file_io.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vkpt {
namespace {

constexpr const char* kPage = "index.html";
constexpr double kQuickQuality = 1.0 / 64.0;
constexpr int kQuickShrink = 4;           // of width and height
constexpr double kStudySeconds = 6.0;     // for a setting and a seed, at full quality
constexpr double kSamplesPerSecond = 1e6; // of a planned run: for the progress line alone

double qualityOf(const AssignmentOptions& o) { return o.quick ? o.quality * kQuickQuality : o.quality; }

/// Words between blanks; files of assets/ with their place.
std::vector<std::string> wordsOf(std::string_view arguments) {
  constexpr std::string_view kAssets = "assets/";
  std::vector<std::string> words;
  std::istringstream stream{std::string(arguments)};
  for (std::string word; stream >> word;) {
    if (word.starts_with(kAssets)) {
      const fs::path file = word.substr(kAssets.size());
      word = (assetsFolder(file) / file).string();
    }
    words.push_back(word);
  }
  return words;
}

/// Both assignments are about independent random numbers and paths from the eye.
void addRunOptions(const AssignmentOptions& o, std::vector<std::string>& words) {
  if (std::ranges::find(words, "--sampler") == words.end())
    words.insert(words.end(), {"--sampler", "independent"});
  if (std::ranges::find(words, "--light-tracing") == words.end())
    words.insert(words.end(), {"--light-tracing", "off"});
  if (std::ranges::find(words, "--specular-samples") == words.end())
    words.insert(words.end(), {"--specular-samples", "1"});
  if (!o.device.empty())
    words.insert(words.end(), {"--device", o.device});
  if (o.validation)
    words.emplace_back("--validation");
}

struct PictureWork {
  const AssignmentPicture* picture = nullptr;
  RenderOptions options;
  PreparedRun prepared;
};

struct ExperimentWork {
  const AssignmentExperiment* experiment = nullptr;
  StudyOptions options;
  LoadedStudy loaded;
};

PictureWork preparePicture(const AssignmentOptions& o, const AssignmentPicture& picture) {
  std::vector<std::string> words = wordsOf(picture.arguments);
  if (picture.samples > 0) {
    const double samples = std::max(2.0, std::round(qualityOf(o) * picture.samples));
    words.insert(words.end(), {"--frames", fmt::format("{:.0f}", samples)});
  } else {
    words.insert(words.end(), {"--time", fmt::format("{}", qualityOf(o) * kEqualSeconds)});
    if (o.quick) // else the time is over within the first unit of work, and some pixels have nothing
      words.insert(words.end(), {"--batch", "1"});
  }
  const std::string file = (o.folder / picture.name).string();
  words.insert(words.end(), {"--output", file + ".png", "--output", file + ".exr"});
  addRunOptions(o, words);
  PictureWork work{&picture, parseCommandLine(words).render, {}};
  work.prepared = prepareRun(work.options);
  if (o.quick) {
    work.prepared.scene.width = std::max(1, work.prepared.scene.width / kQuickShrink);
    work.prepared.scene.height = std::max(1, work.prepared.scene.height / kQuickShrink);
  }
  return work;
}

ExperimentWork prepareExperiment(const AssignmentOptions& o, const AssignmentExperiment& experiment) {
  std::vector<std::string> words = wordsOf(experiment.arguments);
  words.insert(words.end(), {"--time", fmt::format("{}", qualityOf(o) * kStudySeconds)});
  if (o.quick)
    words.insert(words.end(), {"--seeds", "2"});
  addRunOptions(o, words);
  ExperimentWork work{&experiment, parseStudyOptions(words).value(), {}};
  work.options.command = fmt::format(
      "vkpt study {} --sampler independent --light-tracing off --specular-samples 1", experiment.arguments);
  work.loaded = std::move(loadStudies(work.options).front());
  if (o.quick) {
    work.loaded.scene.width = std::max(1, work.loaded.scene.width / kQuickShrink);
    work.loaded.scene.height = std::max(1, work.loaded.scene.height / kQuickShrink);
  }
  return work;
}

double plannedSeconds(const PictureWork& work) {
  const RenderJob& job = work.prepared.job;
  const Scene& scene = work.prepared.scene;
  return job.seconds.value_or(static_cast<double>(job.frames.value_or(0)) * scene.width * scene.height /
                              kSamplesPerSecond);
}

double plannedSeconds(const ExperimentWork& work) {
  const StudyPlan& plan = work.loaded.plan;
  return plan.seconds.value_or(0.0) *
         (kReferenceWork + static_cast<double>(plan.settings.size()) * static_cast<double>(plan.seeds));
}

/// A picture's run, for the line that tells of all.
class PictureObserver : public RenderObserver {
public:
  PictureObserver(WorkLine& line, std::string_view name) : m_line(line), m_name(name) {}
  void onProgress(const RenderProgress& p) override {
    const double all = p.seconds + p.remainingSeconds.value_or(0.0);
    m_line.tell(all > 0.0 ? p.seconds / all : 0.0, m_name);
  }
  bool stopRequested() override { return InterruptGuard::requested(); }

private:
  WorkLine& m_line;
  std::string m_name;
};

/// All that was asked for, one after the other; ends early when the user wishes so.
class AssignmentRun {
public:
  AssignmentRun(const AssignmentOptions& o) : m_options(o) {
    for (const AssignmentPicture& picture : picturesOf(o.sheet)) {
      if (o.wants(picture.name))
        m_pictures.push_back(preparePicture(o, picture));
    }
    if (o.only.empty()) {
      for (const AssignmentExperiment& experiment : experimentsOf(o.sheet))
        m_experiments.push_back(prepareExperiment(o, experiment));
    }
    m_results.sheet = o.sheet;
    m_results.command = o.command;
    m_results.complete = o.only.empty();
  }

  AssignmentResults run(const gpu::Context& context) {
    std::vector<double> planned;
    for (const auto& work : m_pictures)
      planned.push_back(plannedSeconds(work));
    for (const auto& work : m_experiments)
      planned.push_back(plannedSeconds(work));
    WorkLine line(m_options.progress, planned);
    for (const auto& work : m_pictures)
      render(work, context, line);
    for (const auto& work : m_experiments)
      study(work, context, line);
    m_results.complete = m_results.complete && !InterruptGuard::requested();
    return std::move(m_results);
  }

private:
  void render(const PictureWork& work, const gpu::Context& context, WorkLine& line) {
    if (InterruptGuard::requested())
      return;
    PictureObserver observer(line, work.picture->name);
    const FinishedRun run = renderRun(work.options, work.prepared, context, observer);
    writeImages(work.options, run.report, run.film, run.kinds);
    m_results.pictures.push_back({work.picture, run.report});
    line.next();
  }

  void study(const ExperimentWork& work, const gpu::Context& context, WorkLine& line) {
    if (InterruptGuard::requested())
      return;
    const auto observer = [&](const StudyProgress& p) {
      line.tell(p.share, fmt::format("{}: {}", work.experiment->name, p.what));
      return !InterruptGuard::requested();
    };
    m_results.experiments.push_back(
        {work.experiment, runLoaded(work.options, work.loaded, context, observer)});
    line.next();
  }

  const AssignmentOptions& m_options;
  std::vector<PictureWork> m_pictures;
  std::vector<ExperimentWork> m_experiments;
  AssignmentResults m_results;
};

/// The XML file that sheet B asks for, with the meshes that it names.
void copyOwnScene(const fs::path& folder) {
  const fs::path name = "q-scene.xml";
  const fs::path from = assetsFolder(name);
  const film::Bytes bytes = film::readWholeFile(from / name);
  const std::string xml(bytes.begin(), bytes.end());
  fs::create_directories(folder / "scene" / "meshes");
  constexpr auto kReplace = fs::copy_options::overwrite_existing;
  fs::copy_file(from / name, folder / "scene" / name, kReplace);
  for (const auto& mesh : fs::directory_iterator(from / "meshes")) {
    const fs::path file = fs::path("meshes") / mesh.path().filename();
    if (xml.find('"' + file.string() + '"') != std::string::npos)
      fs::copy_file(from / file, folder / "scene" / file, kReplace);
  }
}

ExitCode conclude(const AssignmentOptions& o, const AssignmentResults& results) {
  if (o.log != LogLevel::Quiet) {
    for (const DrawnPicture& drawn : results.pictures)
      fmt::print("{:<21} {:>8.6g} samples per pixel in {:.2f} s\n", drawn.picture->name,
                 drawn.report.result.frames, drawn.report.seconds.render);
    fmt::print("written: {}\n", (o.folder / kPage).string());
  }
  ExitCode code = InterruptGuard::requested() ? ExitCode::Interrupted : ExitCode::Done;
  for (const DrawnPicture& drawn : results.pictures) {
    if (drawn.report.counters.faults() > 0) {
      spdlog::error("{}: {}; the image is wrong there", drawn.picture->name,
                    faultText(drawn.report.counters));
      code = std::max(code, ExitCode::Faults);
    }
  }
  for (const DoneExperiment& done : results.experiments)
    code = std::max(code, exitCodeOf(done.section.result));
  return code;
}

} // namespace

ExitCode runAssignment(const std::vector<std::string>& arguments) {
  const auto o = parseAssignmentOptions(arguments);
  if (!o)
    return ExitCode::Done;
  setUpLog(o->log);
  checkGnuplot();
  checkFolder(o->folder, o->force);
  const InterruptGuard interrupts;
  AssignmentRun run(*o);
  const gpu::Context context({o->device, o->validation, pipelineCacheFolder()});
  makeFolder(o->folder, kPage);
  const AssignmentResults results = run.run(context);
  if (o->sheet == Sheet::B)
    copyOwnScene(o->folder);
  writeAssignmentPage(o->folder, results);
  if (context.validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  return conclude(*o, results);
}

} // namespace vkpt
