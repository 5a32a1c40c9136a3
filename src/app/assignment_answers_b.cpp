// Exercise 4: path integrals, Russian roulette, a scene of our own.

#include "app/assignment_answers.h"
#include "core/duration.h"
#include "study/html.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt {
namespace {

constexpr const char* kHits = R"(
<blockquote>If this ray does not hit any objects or if it hits a light source, what should you do?</blockquote>
<p>If it leaves the scene, the path ends: nothing more can be found there but the background, which is 0 here and is
added where it is not. If it hits a light source, its emission is added only when the ray is the eye's own, or comes from
a specular surface. For every other vertex, light area sampling has already taken the contribution of paths that end on
that light; adding it again would count the direct light twice. The path also goes on from there, since a light's surface
reflects too if its BRDF is not black.</p>
<p>The sum up to depth 3: emission seen by the eye, the light sample at the first vertex, one BRDF sample that gives the
second vertex, and the light sample there, weighted by the throughput f cosθ / p of that segment.</p>
)";

constexpr const char* kRoulette = R"(
<blockquote>How do you change the throughput of new path to maintain an unbiased estimator?</blockquote>
<p>After the second bounce a path ends with probability q. A path that goes on has its throughput divided by the
probability of that, β ← β f cosθ / (p (1 − q)). If X is what the rest of the path would have brought, the estimator is
X / (1 − q) with probability 1 − q and 0 with probability q, whose expectation is (1 − q) · X / (1 − q) + q · 0 = X. So the
image's expectation does not depend on q at all, as long as q &lt; 1; with q = 1 no path goes on, and what longer paths
carry is missing: a bias.</p>
<p>What it costs is variance. A path of n bounces weighs (1 − q)<sup>−(n − 2)</sup>, while the surfaces damp it only by
their albedo ρ each: where ρ² &gt; 1 − q the second moments of ever longer paths grow without bound, and the variance is
infinite. For a white wall (ρ = 0.9) that is so for every q above 0.19.</p>
)";

constexpr const char* kOwn = R"(
<p>The scene, <code>scene/q-scene.xml</code> in this folder with its meshes: four chambers in a row, each lit through a
gap in its left wall alone. The lamp stands in the first one behind a screen and shines backwards. Every chamber farther
from it needs more bounces, so q decides how far the light seems to reach.</p>
)";

constexpr const char* kFaster = R"(
<blockquote>What technique could be applied to make the image converge faster?</blockquote>
<p>Multiple importance sampling: the light samples are noise where a glossy, mirror-like lobe is narrow, because a point
on the lamp rarely lies in it; a direction sampled from the lobe finds the lamp at once. Weighting both by the power
heuristic takes each where it is good. And a roulette that follows the throughput in place of a constant q, which ends
only what carries little. The second picture has both. What would help further: more evenly spread samples
(Sobol' or other low-discrepancy points), bidirectional path tracing or photon maps for what the mirrors and glass focus,
and path guiding.</p>
)";

/// The settings of the study of q in words.
std::string studyResult(const AssignmentBook& book) {
  const DoneExperiment* done = book.experiment("q");
  if (done == nullptr)
    return {};
  const StudyResult& result = done->section.result;
  const auto summaries = summarise(result);
  std::string html = fmt::format("<p>Measured against a reference that has no such q, over several seeds ({} "
                                 "samples per pixel; {:.3g} s "
                                 "of time):</p><ul>",
                                 result.equalFrames, result.equalSeconds);
  for (const SettingSummary& s : summaries) {
    html += fmt::format("<li>{}: ", html::escaped(s.name));
    if (s.errorAtEqualFrames)
      html += fmt::format("error {:.3g} % at equal samples, ", s.errorAtEqualFrames->median * 100.0);
    if (s.errorAtEqualTime)
      html += fmt::format("{:.3g} % at equal time, ", s.errorAtEqualTime->median * 100.0);
    html += fmt::format("{:.2f} times the time of q = 1 a sample, energy {:+.1f} %</li>",
                        s.secondsPerFrame / summaries.front().secondsPerFrame, s.energy.value * 100.0);
  }
  return html + "</ul>";
}

/// The best at equal time of those without bias.
std::string equalTimeVerdict(const AssignmentBook& book) {
  const DoneExperiment* done = book.experiment("q");
  if (done == nullptr)
    return {};
  const SettingSummary* best = nullptr;
  const auto summaries = summarise(done->section.result);
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const SettingSummary& s = summaries[i];
    const bool chosen = done->section.result.settings[i].setting.bias.empty() && s.errorAtEqualTime;
    if (chosen && (best == nullptr || s.errorAtEqualTime->median < best->errorAtEqualTime->median))
      best = &s;
  }
  if (best == nullptr)
    return {};
  return fmt::format("<p>At equal time the lowest error of the unbiased ones had {}, in this run.</p>",
                     html::escaped(best->name));
}

/// How many times longer a took than b.
std::string times(const AssignmentBook& book, std::string_view a, std::string_view b) {
  const RunReport* of = book.find(a);
  const RunReport* to = book.find(b);
  if (of == nullptr || to == nullptr)
    return "–";
  return fmt::format("{:.2f}", of->seconds.render / std::max(to->seconds.render, 1e-9));
}

/// Mean radiance, channels alike, as a share of another picture's.
std::string light(const AssignmentBook& book, std::string_view a, std::string_view b) {
  const RunReport* of = book.find(a);
  const RunReport* to = book.find(b);
  if (of == nullptr || to == nullptr)
    return "–";
  const auto sum = [](const Vec3d& v) { return v.x + v.y + v.z; };
  return fmt::format("{:.3g} %", 100.0 * sum(of->film.mean) / sum(to->film.mean));
}

std::string pathIntegrals(const AssignmentBook& book) {
  return std::string("<h2>4.2.1 Path integrals</h2>") + kHits + book.figures({"b-busts"}) +
         book.table({"b-busts"}) +
         "<p>Diffuse left, Phong right, no roulette, paths of up to three edges. The busts stand in for the "
         "Ajax "
         "statue, whose mesh may not be handed on.</p>";
}

std::string roulette(const AssignmentBook& book) {
  return std::string("<h2>4.2.2 Russian roulette</h2>") + kRoulette +
         book.figures({"b-cbox-q1.0", "b-cbox-q0.7", "b-cbox-q0.4", "b-cbox-q0.1"}) +
         book.table({"b-cbox-q1.0", "b-cbox-q0.7", "b-cbox-q0.4", "b-cbox-q0.1"}) +
         fmt::format("<p>Time: a smaller q means longer paths. At {} samples per pixel q = 0.7, 0.4 and 0.1 "
                     "took {}, {} and {} "
                     "times as long as q = 1. Result: q = 1 has {} of the mean light of q = 0.1; what is "
                     "missing is what needs "
                     "more than two bounces, the green right of the small box above all. q = 0.7 and 0.4 "
                     "have it in the mean, "
                     "but as few bright dots, since the few paths that go on weigh much; with q = 0.1 the "
                     "same light is spread "
                     "over many paths of little weight. The estimated errors are {}, {} and {} (q = 0.7, "
                     "0.4, 0.1); those "
                     "marked † have so heavy a tail that they understate it.</p>",
                     book.samples("b-cbox-q0.1"), times(book, "b-cbox-q0.7", "b-cbox-q1.0"),
                     times(book, "b-cbox-q0.4", "b-cbox-q1.0"), times(book, "b-cbox-q0.1", "b-cbox-q1.0"),
                     light(book, "b-cbox-q1.0", "b-cbox-q0.1"), book.error("b-cbox-q0.7"),
                     book.error("b-cbox-q0.4"), book.error("b-cbox-q0.1"));
}

std::string ownScene(const AssignmentBook& book) {
  return std::string("<h2>4.2.3 A scene of our own</h2>") + kOwn + "<h3>Equal samples</h3>" +
         book.figures({"b-own-q1.0", "b-own-q0.7", "b-own-q0.4", "b-own-q0.1"}) +
         book.table({"b-own-q1.0", "b-own-q0.7", "b-own-q0.4", "b-own-q0.1"}) +
         "<p>q = 1 stops after two bounces: all but the first chambers are black. The smaller q, the farther "
         "the light "
         "reaches without breaking up into dots.</p><h3>Equal time</h3>" +
         book.figures({"b-own-time-q1.0", "b-own-time-q0.7", "b-own-time-q0.4", "b-own-time-q0.1"}) +
         book.table({"b-own-time-q1.0", "b-own-time-q0.7", "b-own-time-q0.4", "b-own-time-q0.1"}) +
         fmt::format("<p>In {} each: q = 1 traces {} samples per pixel, q = 0.7 {}, q = 0.4 {}, q = 0.1 {}. "
                     "A large q buys many "
                     "short paths that refine what is lit after two bounces and was smooth already; the far "
                     "chambers get few and "
                     "heavy ones. A small q spends the same time on fewer, longer paths, and these reach the "
                     "far chambers.</p>",
                     book.seconds("b-own-time-q0.1"), book.samples("b-own-time-q1.0"),
                     book.samples("b-own-time-q0.7"), book.samples("b-own-time-q0.4"),
                     book.samples("b-own-time-q0.1")) +
         studyResult(book) + equalTimeVerdict(book) + book.study("q");
}

} // namespace

std::string answersOfB(const AssignmentBook& book) {
  return pathIntegrals(book) + roulette(book) + ownScene(book) +
         "<h2>Figure 3: several meshes in the box</h2>" + book.figures({"b-meshes", "b-meshes-mis"}) +
         book.table({"b-meshes", "b-meshes-mis"}) + kFaster +
         fmt::format(
             "<p>At {} samples per pixel the estimated relative error is {} with light sampling and q = 0.1 "
             "(in {}), and {} with multiple importance sampling and roulette by throughput (in {}).</p>",
             book.samples("b-meshes"), book.error("b-meshes"), book.seconds("b-meshes"),
             book.error("b-meshes-mis"), book.seconds("b-meshes-mis"));
}

} // namespace vkpt
