// Worksheet 5: the Cornell box with blocks and with spheres, caustics, splitting.

#include "app/annotated_picture.h"
#include "app/assignment_answers.h"
#include "app/embedded_shaders.h"
#include "film/file_io.h"
#include "study/html.h"

#include <fmt/format.h>

#include <array>

namespace vkpt {
namespace {

/// Where the secondary caustics of cornell-spheres are, by the fitted camera.
constexpr std::array kSecondaryCaustics{
    Annotation{0.605, 0.845, 0.43, 0.95, "green spot"},
    Annotation{0.825, 0.845, 0.74, 0.96, "orange spot"},
    Annotation{0.215, 0.690, 0.04, 0.52, "red glow"},
    Annotation{0.400, 0.790, 0.10, 0.90, "pale pool"},
    Annotation{0.870, 0.650, 0.72, 0.48, "green glow"},
    Annotation{0.705, 0.868, 0.56, 0.56, "under the glass"},
    Annotation{0.480, 0.110, 0.30, 0.33, "ceiling, walls"},
};

constexpr const char* kEmission = R"(
<h3>What is done when a ray hits the light, and why</h3>
<p>At every diffuse point the light's area is sampled explicitly (next event estimation), so the term with the lamp as
the next vertex is already in the sum. Were the lamp's emission added again when the ray that was sampled from the BRDF
happens to hit it, that light would count twice. So emission is added only where no light sample could have stood for
it: at the camera's own ray, and behind a mirror, metal or glass, whose directions are no density that light sampling
could meet. The caustics come from just these paths: a diffuse point, then a sphere, then by chance the lamp.</p>
<p>Roulette: at a diffuse surface one secondary ray is traced with a probability of the mean diffuse reflectance, in a
direction with density cosθ/π; a ray that is traced carries ρ / P(traced) times the throughput, so that those that are
traced stand for those that are not, and the expectation is unchanged.</p>
)";

constexpr const char* kSecondary = R"(
<p>Notation from the light to the eye: L the lamp, D a diffuse, S<sub>r</sub> a reflected, S<sub>t</sub> a transmitted
event, E the eye. The primary caustics are L (S<sub>r</sub> | S<sub>t</sub>S<sub>t</sub>) D E. A secondary caustic has a
further event before it goes that way, or after it. In the picture:</p>
<ol>
<li>The green spot on the floor left of the glass sphere: light that the green wall reflected diffusely is focused by
the glass on the far side, L D S<sub>t</sub> S<sub>t</sub> D E.</li>
<li>The orange spot right of it: the same from the red wall and the floor before it, L D S<sub>t</sub> S<sub>t</sub> D
E.</li>
<li>The red glow on the left wall: what the silver sphere throws there of the lit room, L D S<sub>r</sub> D E. It is red
because the last D is the red wall.</li>
<li>The pale pool on the floor before the silver sphere, and its reddish part at the left: light of walls and ceiling
that the sphere reflects down, L D S<sub>r</sub> D E.</li>
<li>The green glow on the right wall: the room's light focused through the glass sphere, L D S<sub>t</sub>
S<sub>t</sub> D E, and what the sphere reflects, L D S<sub>r</sub> D E.</li>
<li>Under the glass sphere, beside the primary spot: light of the ceiling focused through it, L D S<sub>t</sub>
S<sub>t</sub> D E, and light of the lamp that was reflected inside the glass on its way, L S<sub>t</sub> S<sub>r</sub>
S<sub>t</sub> D E, or met both spheres, L S<sub>r</sub> S<sub>t</sub> S<sub>t</sub> D E.</li>
<li>The weak glow on ceiling and walls: the bright primary spot lights them through the sphere again, L S<sub>t</sub>
S<sub>t</sub> D S<sub>t</sub> S<sub>t</sub> D E, and the silver sphere sends the floor's light up, L D S<sub>r</sub> D
E.</li>
</ol>
<p>What is seen in the spheres themselves (the green spot in the silver one) is one of these, mirrored on its way to the
eye.</p>
)";

constexpr const char* kSplitting = R"(
<p>Where: at glass, up to trace depth N, both branches are followed, each weighted by its Fresnel share, R and 1 − R;
one branch waits while the other is traced, so a sample becomes a small tree. At the silver sphere there is one branch
only: up to that depth roulette may not end the path there. Deeper, one branch is chosen at random with probability R or
1 − R, which is roulette with weights of one. Both are unbiased: R·f<sub>r</sub> + (1 − R)·f<sub>t</sub> is exactly the
expectation of the random choice. Splitting removes the variance of that choice, at the price of up to twice the rays at
every glass surface.</p>
)";

std::string annotated(const AssignmentBook& book, const std::string& name) {
  const RunReport* r = book.find(name);
  if (r == nullptr)
    return {};
  const fs::path svg = book.folder() / (name + "-annotated.svg");
  film::writeTextFile(svg,
                      annotatedSvg(book.folder() / (name + ".png"), r->width, r->height, kSecondaryCaustics));
  return fmt::format("<p><img class=annotated alt='secondary caustics, numbered' src='{}'></p>",
                     html::dataUrl(svg, "image/svg+xml"));
}

/// What the study of one kind of caustics says, in a sentence for each depth.
std::string splittingResult(const AssignmentBook& book, std::string_view name, std::string_view caustics) {
  const DoneExperiment* done = book.experiment(name);
  if (done == nullptr)
    return {};
  const auto summaries = summarise(done->section.result);
  std::vector<std::vector<std::string>> rows;
  for (const SettingSummary& s : summaries) {
    const auto samples = samplesForEqualError(summaries.front(), s);
    rows.push_back({html::escaped(s.name), samples ? fmt::format("{:.2f}", *samples) : "–",
                    fmt::format("{:.2f}", s.secondsPerFrame / summaries.front().secondsPerFrame),
                    s.efficiency ? fmt::format("{:.2f}", *s.efficiency) : "–",
                    s.slopeOverFrames ? fmt::format("{:.2f}", s.slopeOverFrames->value) : "–"});
  }
  return fmt::format("<p>The {} caustics, against depth 0:</p>", caustics) +
         html::table({"setting", "samples for the same error", "time a sample", "efficiency at equal time",
                      "slope of log MSE over samples"},
                     rows);
}

std::string code() {
  const EmbeddedAsset& text = embeddedShaders().front();
  return fmt::format(
      "<h2>Relevant code</h2><p><code>shaders/lib/{}</code>: <code>Li</code> extends a path by one "
      "vertex, with the sections EMISSION, DIRECT, INDIRECT, SPLITTING and ROULETTE. "
      "<code>MUTATE(name, a, b)</code> is a; tests switch to the wrong b.</p>"
      "<details><summary>the file</summary><pre>{}</pre></details>",
      text.name, html::escaped(text.text));
}

} // namespace

std::string answersOfA(const AssignmentBook& book) {
  std::string html =
      "<h2>1. The box with the blocks</h2>" + book.figures({"a-blocks"}) + book.table({"a-blocks"});
  html += fmt::format(
      "<p>Rendered in {} with {} samples per pixel and one light sample at each point; background "
      "0. The estimated relative error of the image is {}. The colour bleeding is the red and green "
      "on the blocks, the ceiling and the floor beside the walls.</p>",
      book.seconds("a-blocks"), book.samples("a-blocks"), book.error("a-blocks"));
  html += kEmission;
  html += "<h2>2. A silver and a glass sphere</h2>" + book.figures({"a-spheres"}) + book.table({"a-spheres"});
  html += fmt::format(
      "<p>Rendered in {} with {} samples per pixel; the estimated relative error is {}. The bright "
      "dots are rare samples of the primary caustics, whose paths find the lamp by chance.</p>",
      book.seconds("a-spheres"), book.samples("a-spheres"), book.error("a-spheres"));
  html += "<h2>3. Primary and secondary caustics</h2>" +
          book.figures({"a-primary-caustics", "a-secondary-caustics"}) +
          book.table({"a-primary-caustics", "a-secondary-caustics"}) +
          annotated(book, "a-secondary-caustics") + kSecondary +
          "<p>The same places in the whole picture:</p>" + annotated(book, "a-spheres");
  html +=
      std::string("<h2>4. Splitting against Russian roulette</h2>") + kSplitting +
      book.figures({"a-roulette", "a-split-1", "a-split-2", "a-split-4"}) +
      book.table({"a-roulette", "a-split-1", "a-split-2", "a-split-4"}) +
      splittingResult(book, "splitting-primary", "primary") +
      splittingResult(book, "splitting-secondary", "secondary") +
      "<p>How to read it: the glass of a primary caustic stands behind a diffuse bounce, at trace depth 2 "
      "and 3, "
      "so depth 1 changes nothing for it but the glass that the eye looks through. A number of samples below "
      "1 "
      "is what splitting saves; an efficiency above 1 is what is left of that after the time of the extra "
      "rays. "
      "What is rare in a caustic is that a diffuse point's ray finds the sphere and behind it the lamp; the "
      "choice of the branch is the smaller part of the variance, so splitting cannot remove more than that "
      "part.</p>" +
      book.study("splitting-primary") + book.study("splitting-secondary");
  return html + code();
}

} // namespace vkpt
