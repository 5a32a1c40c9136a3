#include "study/pilot.h"

#include "core/clock.h"
#include "scene/image_size.h"
#include "study/setting_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>

namespace vkpt {
namespace {

constexpr double kMostPixels = 96.0 * 96.0; // of the small image
constexpr std::uint64_t kLeastFrames = 64;  // the replicates tell their error from 32 on
constexpr double kUnknown = 1e-3;           // of the pixels: their errors

struct Answer {
  const char* value;
  void (*set)(EstimatorSettings&);
};

struct Question {
  const char* option;
  Effect effect; ///< that an answer, or what there is, must call for: else the scene has nothing that it is
                 ///< about
  bool isNumber; ///< else its answers differ in that effect alone
  std::span<const Answer> answers;
};

constexpr Answer kLightTracing[] = {
    {"auto", [](EstimatorSettings& e) { e.lightTracing = LightTracing::Auto; }},
    {"off", [](EstimatorSettings& e) { e.lightTracing = LightTracing::Off; }}};
constexpr Answer kGuiding[] = {{"auto", [](EstimatorSettings& e) { e.guiding = Guiding::Auto; }},
                               {"off", [](EstimatorSettings& e) { e.guiding = Guiding::Off; }}};
constexpr Answer kLightSelection[] = {
    {"power", [](EstimatorSettings& e) { e.lightSelection = LightSelection::Power; }},
    {"tree", [](EstimatorSettings& e) { e.lightSelection = LightSelection::Tree; }}};
constexpr Answer kSpecularSamples[] = {{"1", [](EstimatorSettings& e) { e.specularSamples = 1; }},
                                       {"2", [](EstimatorSettings& e) { e.specularSamples = 2; }},
                                       {"4", [](EstimatorSettings& e) { e.specularSamples = 4; }},
                                       {"8", [](EstimatorSettings& e) { e.specularSamples = 8; }}};
constexpr Answer kPathReuse[] = {{"1", [](EstimatorSettings& e) { e.pathReuse = 1; }},
                                 {"16", [](EstimatorSettings& e) { e.pathReuse = 16; }},
                                 {"64", [](EstimatorSettings& e) { e.pathReuse = 64; }}};
constexpr Answer kSplit[] = {{"0", [](EstimatorSettings& e) { e.splitDepth = 0; }},
                             {"1", [](EstimatorSettings& e) { e.splitDepth = 1; }},
                             {"2", [](EstimatorSettings& e) { e.splitDepth = 2; }}};

/// What matters most comes first; splitting last, since it can't go together with shared paths.
constexpr Question kQuestions[] = {
    {"--light-tracing", Effect::LightTracing, false, kLightTracing},
    {"--light-selection", Effect::LightTree, false, kLightSelection},
    {"--path-reuse", Effect::PathReuse, true, kPathReuse},
    {"--specular-samples", Effect::SpecularSamples, true, kSpecularSamples},
    {"--guiding", Effect::Guiding, false, kGuiding},
    {"--split", Effect::Splitting, true, kSplit},
};

Scene smaller(const Scene& scene) {
  Scene small = scene;
  const double pixels = static_cast<double>(scene.width) * scene.height;
  scaleImage(small, std::min(1.0, std::sqrt(kMostPixels / pixels)));
  return small;
}

/// One setting at work.
struct Contender {
  std::string option; ///< "--path-reuse 64"
  EstimatorSettings estimator;
  std::unique_ptr<SettingRun> run;
  Film film{}; ///< at the end
};

/// What the contenders have rendered together: they have one expectation.
std::vector<Vec3d> pooledMean(const std::vector<Contender>& contenders) {
  std::vector<PixelMoments> pooled(contenders.front().film.pixels.size());
  for (const Contender& c : contenders) {
    for (std::size_t i = 0; i < pooled.size(); ++i)
      pooled[i].merge(c.film.pixels[i]);
  }
  std::vector<Vec3d> means;
  means.reserve(pooled.size());
  for (const PixelMoments& p : pooled)
    means.push_back(p.mean);
  return means;
}

/// Mean over pixels of SE^2 / (b^2 + m^2), averaged over the channels, b the image that they have in common
/// and m its mean. Squared standard errors are right at any number of samples; relMSE, by each film's own b,
/// would be too high for few. The few worst pixels, whose errors no short run can know, count as the next
/// worst.
double squaredError(const Film& film, const std::vector<Vec3d>& b) {
  const auto pixels = static_cast<double>(b.size());
  double m = 0.0;
  for (const Vec3d& value : b)
    m += (value.x + value.y + value.z) / (3.0 * pixels);
  std::vector<double> squares(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Vec3d variance = film.pixels[i].varianceOfMean();
    for (int c = 0; c < 3; ++c)
      squares[i] += variance[c] == 0.0 ? 0.0 : variance[c] / (b[i][c] * b[i][c] + m * m) / 3.0;
  }
  std::ranges::sort(squares);
  const auto unknown = static_cast<std::ptrdiff_t>(kUnknown * pixels);
  std::fill(squares.end() - unknown, squares.end(), *(squares.end() - unknown - 1));
  return std::reduce(squares.begin(), squares.end()) / pixels;
}

class Pilot {
public:
  Pilot(const gpu::Context& context, const Scene& scene, const PilotPlan& plan,
        const std::function<bool(const std::string&)>& observer)
      : m_context(context), m_scene(smaller(scene)), m_plan(plan), m_observer(observer),
        m_estimator(plan.estimator) {
    m_result.width = m_scene.width;
    m_result.height = m_scene.height;
  }

  PilotResult run() {
    const Stopwatch watch;
    for (const Question& question : kQuestions) {
      if (std::ranges::find(m_plan.fixed, question.option) != m_plan.fixed.end())
        continue;
      std::vector<Contender> contenders = contendersFor(question);
      if (contenders.size() < 2)
        continue;
      if (!compete(contenders))
        break;
      keepBest(contenders);
    }
    m_result.seconds = watch.seconds();
    return std::move(m_result);
  }

private:
  /// What there is, and each answer that makes another render of it.
  [[nodiscard]] std::vector<Contender> contendersFor(const Question& question) const {
    std::vector<Contender> contenders;
    contenders.push_back({"settings as they are", m_estimator, {}});
    const bool had = m_plan.effectsOf(m_estimator).has(question.effect);
    for (const Answer& answer : question.answers) {
      EstimatorSettings e = m_estimator;
      answer.set(e);
      if (e == m_estimator || pathReuseObstacle(e))
        continue;
      const bool has = m_plan.effectsOf(e).has(question.effect);
      if (question.isNumber ? !had && !has : had == has)
        continue;
      contenders.push_back({fmt::format("{} {}", question.option, answer.value), e, {}});
    }
    return contenders;
  }

  /// False where the observer has ended it.
  bool compete(std::vector<Contender>& contenders) const {
    for (Contender& c : contenders) {
      if (!m_observer("compiling: " + c.option))
        return false;
      StudySetting setting;
      setting.estimator = c.estimator;
      setting.filter = m_scene.filter;
      setting.effects = m_plan.effectsOf(c.estimator);
      c.run = std::make_unique<SettingRun>(m_context, m_scene, setting);
      c.run->restart(m_plan.seed);
    }
    const auto isDone = [&](const Contender& c) {
      return c.run->frames() >= kLeastFrames && c.run->seconds() >= m_plan.seconds;
    };
    for (;;) {
      const auto next = std::ranges::min_element(
          contenders, {}, [&](const Contender& c) { return isDone(c) ? HUGE_VAL : c.run->seconds(); });
      if (isDone(*next))
        break;
      if (!m_observer(next->option))
        return false;
      next->run->step({}, {});
    }
    for (Contender& c : contenders)
      c.film = c.run->film();
    return true;
  }

  void keepBest(const std::vector<Contender>& contenders) {
    const std::vector<Vec3d> common = pooledMean(contenders);
    const auto efficiency = [&](const Contender& c) {
      return 1.0 / (squaredError(c.film, common) * c.run->seconds());
    };
    const double before = efficiency(contenders.front());
    const std::size_t first = m_result.trials.size();
    double best = kPilotGain;
    std::size_t kept = 0;
    for (std::size_t i = 1; i < contenders.size(); ++i) {
      const double now = efficiency(contenders[i]);
      const double gain = now == before ? 1.0 : now / before; // both infinite where nothing is noisy
      m_result.trials.push_back({contenders[i].option, gain, false});
      if (gain > best) {
        best = gain;
        kept = i;
      }
    }
    if (kept > 0) {
      m_estimator = contenders[kept].estimator;
      m_result.trials[first + kept - 1].kept = true;
    }
  }

  const gpu::Context& m_context;
  Scene m_scene;
  const PilotPlan& m_plan;
  const std::function<bool(const std::string&)>& m_observer;
  EstimatorSettings m_estimator; ///< with what was kept
  PilotResult m_result;
};

} // namespace

PilotResult runPilot(const gpu::Context& context, const Scene& scene, const PilotPlan& plan,
                     const std::function<bool(const std::string& what)>& observer) {
  return Pilot(context, scene, plan, observer).run();
}

} // namespace vkpt
