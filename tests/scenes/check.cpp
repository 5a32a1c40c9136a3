#include "scenes/check.h"

#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::test {
namespace {

constexpr double kFloatRounding = 0x1p-24;
constexpr double kMeanBound = 4.0; // standard errors
constexpr const char* kChannels[] = {"red", "green", "blue"};

} // namespace

RenderSetup Trial::complete(RenderSetup setup) {
  setup.kernel = m_kernel;
  if (setup.seed == 0)
    setup.seed = seedOf(fmt::format("{}#{}", m_check, m_renders));
  ++m_renders;
  return setup;
}

Rendered Trial::render(const Scene& scene, const RenderSetup& setup) {
  Rendered r = renderScene(scene, complete(setup));
  expect(r.counters.faults() == 0, fmt::format("{} faults", r.counters.faults()));
  m_pictures.push_back(r.film);
  return r;
}

void Trial::expect(bool holds, const std::string& what) {
  if (!holds)
    m_failures.push_back(fmt::format("{}: {}", m_check, what));
}

void Trial::demandCalm(double error, double bias, const std::string& figures) {
  if (m_kernel.mutation == 0)
    expect(error < bias / 3.0, figures + ": too noisy to tell");
}

void Trial::expectMean(const Film& film, const Vec3d& expected, double tolerance, const std::string& what) {
  const Estimate e = estimateOf(film);
  for (int c = 0; c < 3; ++c) {
    const double error = std::sqrt(e.variance[c]);
    const std::string figures = fmt::format("{} {}: {:.7g} +- {:.2g}, expected {:.7g}", kChannels[c], what,
                                            e.mean[c], error, expected[c]);
    if (expected[c] == 0.0) {
      expect(e.mean[c] == 0.0, figures);
      continue;
    }
    // A result without variance is as exact as floats are.
    const double rounding = 16.0 * kFloatRounding * std::abs(expected[c]);
    expect(std::abs(e.mean[c] - expected[c]) <= kMeanBound * error + rounding, figures);
    demandCalm(error, tolerance * expected[c], figures);
  }
}

void Trial::expectConstant(const Film& film, const Vec3d& value, int operations, const std::string& what) {
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const PixelMoments& p = film.at(x, y);
      const Vec3d allowed = glm::abs(value) * (operations * kFloatRounding);
      const bool near = glm::all(glm::lessThanEqual(glm::abs(p.mean - value), allowed));
      if (near && p.m2 == Vec3d(0.0))
        continue;
      expect(false, fmt::format("{}: pixel ({}, {}) is {:.9g} {:.9g} {:.9g}, expected {:.9g} {:.9g} {:.9g}; "
                                "squared deviations {:g} {:g} {:g}, expected 0",
                                what, x, y, p.mean.x, p.mean.y, p.mean.z, value.x, value.y, value.z, p.m2.x,
                                p.m2.y, p.m2.z));
      return;
    }
  }
}

Rendered Trial::expectSameWhenCarried(const Scene& scene, RenderSetup setup) {
  setup.seed = seedOf(m_check);
  const Rendered whole = render(scene, setup);
  setup.batch = 1;
  const Rendered single = render(scene, setup);
  if (m_kernel.mutation == 0) {
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
    const std::string figures = fmt::format("{} {}: {:.7g} against {:.7g}, z = {:.2f}", kChannels[c], what,
                                            ea.mean[c], eb.mean[c], z[c]);
    expect(std::abs(z[c]) <= kMeanBound, figures);
    demandCalm(error, tolerance * eb.mean[c], figures);
  }
}

std::vector<Check> allChecks() {
  std::vector<Check> checks;
  for (const auto& some : {filmChecks(), materialChecks(), lightChecks(), deltaChecks(), surfaceChecks(),
                           phongChecks(), environmentChecks(), filterChecks(), rouletteChecks(), kindChecks(),
                           splittingChecks(), strategyChecks(), pathChecks()})
    checks.insert(checks.end(), some.begin(), some.end());
  return checks;
}

const Check& checkNamed(const std::string& name) {
  static const std::vector<Check> checks = allChecks();
  for (const Check& c : checks) {
    if (c.name == name)
      return c;
  }
  throw std::invalid_argument("no check is named " + name);
}

} // namespace vkpt::test
