#include "selftest/trial.h"

#include "selftest/statistics.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::selftest {
namespace {

constexpr double kFloatRounding = 0x1p-24;
constexpr double kMeanBound = 4.0; // standard errors
constexpr const char* kChannels[] = {"red", "green", "blue"};
constexpr std::size_t kMostPictures = 16;

struct Noticed {}; // there is nothing more to learn

} // namespace

Verdict Figure::verdict() const {
  if (!bound)
    return Verdict::Note;
  const bool holds = relation == Relation::AtMost ? value <= *bound : value >= *bound; // false for NaN
  return holds ? Verdict::Pass : Verdict::Fail;
}

std::uint32_t Trial::seed(const std::string& what) const {
  return seedOf(fmt::format("{}#{}", m_check, what)) + m_seed * 0x9E3779B9U;
}

void Trial::run(const std::function<void(Trial&)>& check) {
  try {
    check(*this);
  } catch (const Noticed&) {
  }
}

RenderSetup Trial::complete(RenderSetup setup) {
  if (!isShipped() && !m_failures.empty())
    throw Noticed();
  setup.kernel = m_kernel;
  if (setup.seed == 0)
    setup.seed = seed(std::to_string(m_renders));
  ++m_renders;
  return setup;
}

Rendered Trial::renderFaulty(const Scene& scene, const RenderSetup& setup) {
  Rendered r = renderScene(m_context, scene, complete(setup));
  if (m_pictures.size() < kMostPictures)
    m_pictures.push_back(r.film);
  return r;
}

Rendered Trial::render(const Scene& scene, const RenderSetup& setup) {
  Rendered r = renderFaulty(scene, setup);
  expect(r.counters.faults() == 0,
         fmt::format("{} faults: nonFinite {}, cutTraversal {}, stackOverflow {}, invalidPdf {}",
                     r.counters.faults(), r.counters.nonFinite, r.counters.cutTraversal,
                     r.counters.stackOverflow, r.counters.invalidPdf));
  return r;
}

void Trial::add(Figure figure) {
  if (figure.verdict() == Verdict::Fail) {
    m_failures.push_back(fmt::format("{}: {} {:.6g}, bound {:.6g}{}{}", m_check, figure.name, figure.value,
                                     *figure.bound, figure.detail.empty() ? "" : ": ", figure.detail));
  }
  m_figures.push_back(std::move(figure));
}

void Trial::atMost(const std::string& name, double value, double bound, const std::string& detail) {
  add({name, value, bound, Relation::AtMost, detail});
}
void Trial::atLeast(const std::string& name, double value, double bound, const std::string& detail) {
  add({name, value, bound, Relation::AtLeast, detail});
}
void Trial::note(const std::string& name, double value, const std::string& detail) {
  add({name, value, std::nullopt, Relation::AtMost, detail});
}

void Trial::expect(bool holds, const std::string& what) {
  ++m_conditions;
  if (!holds)
    m_failures.push_back(fmt::format("{}: {}", m_check, what));
}

void Trial::demandCalm(double error, double bias, const std::string& figures) {
  if (isShipped())
    expect(error < bias / 3.0, figures + ": too noisy to tell");
}

void Trial::expectMean(const Film& film, const Vec3d& expected, double tolerance, const std::string& what) {
  const Estimate e = estimateOf(film);
  for (int c = 0; c < 3; ++c) {
    const double error = std::sqrt(e.variance[c]);
    const std::string figures =
        fmt::format("{:.7g} +- {:.2g}, expected {:.7g}", e.mean[c], error, expected[c]);
    const std::string channel = fmt::format("{} {}", kChannels[c], what);
    if (expected[c] == 0.0) {
      expect(e.mean[c] == 0.0, channel + ": " + figures);
      continue;
    }
    // A result without variance is as exact as floats are.
    const double rounding = 16.0 * kFloatRounding * std::abs(expected[c]);
    const double off = std::max(std::abs(e.mean[c] - expected[c]) - rounding, 0.0);
    atMost(channel + ": standard errors off", off == 0.0 ? 0.0 : off / error, kMeanBound, figures);
    demandCalm(error, tolerance * expected[c], channel + ": " + figures);
  }
}

void Trial::expectConstant(const Film& film, const Vec3d& value, int operations, const std::string& what) {
  double worst = 0.0; // in roundings
  double varying = 0.0;
  std::string detail;
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const PixelMoments& p = film.at(x, y);
      varying += p.m2 == Vec3d(0.0) ? 0.0 : 1.0;
      for (int c = 0; c < 3; ++c) {
        const double off = std::abs(p.mean[c] - value[c]);
        const double roundings = off == 0.0 ? 0.0 : off / (kFloatRounding * std::abs(value[c]));
        if (roundings <= worst || std::isnan(worst)) // NaN comes through, and stays
          continue;
        worst = roundings;
        detail = fmt::format("{} of pixel ({}, {}) is {:.9g}, expected {:.9g}", kChannels[c], x, y, p.mean[c],
                             value[c]);
      }
    }
  }
  atMost(what + ": roundings off", worst, operations, detail);
  atMost(what + ": pixels with a variance", varying, 0.0);
}

Rendered Trial::expectSameWhenCarried(const Scene& scene, RenderSetup setup) {
  setup.seed = seed("carried");
  const Rendered whole = render(scene, setup);
  setup.batch = 1;
  const Rendered single = render(scene, setup);
  if (isShipped()) {
    expect(whole.counters.carriedPaths > 50,
           fmt::format("only {} paths were carried over", whole.counters.carriedPaths));
  }
  expect(identical(whole.film, single.film), "batches of 16 and of 1 differ");
  return whole;
}

void Trial::expectEqualMeans(const Film& a, const Film& b, double tolerance, const std::string& what) {
  const Estimate ea = estimateOf(a);
  const Estimate eb = estimateOf(b);
  const Vec3d z = welch(ea, eb);
  for (int c = 0; c < 3; ++c) {
    const double error = std::sqrt(ea.variance[c] + eb.variance[c]);
    const std::string figures = fmt::format("{:.7g} against {:.7g}", ea.mean[c], eb.mean[c]);
    const std::string channel = fmt::format("{} {}", kChannels[c], what);
    atMost(channel + ": standard errors apart", std::abs(z[c]), kMeanBound, figures);
    demandCalm(error, tolerance * eb.mean[c], channel + ": " + figures);
  }
}

} // namespace vkpt::selftest
