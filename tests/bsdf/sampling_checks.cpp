#include "bsdf/sampling_checks.h"

#include "bsdf/cells.h"
#include "bsdf/chi_square.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace vkpt::test {
namespace {

constexpr std::uint32_t kDraws = 1U << 17U;
constexpr std::uint32_t kCompared = 1000; // draws compared one by one
constexpr double kFloatRounding = 0x1p-24;
constexpr double kTolerance = 2e-8; // of a cell's probability: a few thousandths of a draw

double meanChannel(const Vec3d& v) { return (v.x + v.y + v.z) / 3.0; }
Vec3d normalOf(const View& view) { return glm::normalize(Vec3d(view.n)); }

std::function<Vec2d(double, double)> integrandOf(const BsdfBench& bench, const BsdfCase& c,
                                                 const Chart& chart) {
  return [&bench, &c, &chart](double u, double v) {
    const auto wi = u < 1.0 ? chart.direction(u, v) : std::nullopt;
    if (!wi)
      return Vec2d(0.0);
    const OracleValue value = bench.oracle.evaluate(c.view, *wi);
    const double fCos = meanChannel(value.f) * std::abs(glm::dot(normalOf(c.view), *wi));
    return Vec2d(value.pdf_w, fCos) * chart.jacobian(u, v);
  };
}

/// Index of the chart and the cell that a draw falls into; one beyond all of them if none.
std::size_t cellOf(const BsdfCase& c, const Grid& grid, const Vec3d& wi) {
  for (std::size_t i = 0; i < c.charts.size(); ++i) {
    if (const auto position = c.charts[i].locate(wi))
      return i * grid.size() + grid.cellOf(*position);
  }
  return c.charts.size() * grid.size();
}

bool isFinite(const BsdfDraw& d) {
  return std::isfinite(d.pdf_w) && std::isfinite(d.weight.x) && std::isfinite(d.weight.y) &&
         std::isfinite(d.weight.z) && std::isfinite(d.wi.x) && std::isfinite(d.wi.y) && std::isfinite(d.wi.z);
}

bool differ(double value, double expected, double tolerance) {
  // Vulkan grants exp(x) 3 + 2 |x| ulp, and 0 below the least float, which is then times a lobe's peak.
  constexpr double kOfExp = (3 + 2 * 88) * 2 * kFloatRounding;
  constexpr double kLeastFloat = 0x1p-126;
  constexpr double kHighestPeak = 1e9;
  const double rounding = kOfExp * std::abs(expected) + kLeastFloat * kHighestPeak;
  return !(std::abs(value - expected) <= tolerance + rounding);
}

} // namespace

BsdfBench::BsdfBench(std::uint32_t mutation)
    : scene(sceneOf(materialCases())), probe(scene, effectsOf(scene), mutation),
      oracle(probe.packed(), probe.constants(), effectsOf(scene)) {}

double roundingOf(const Vec3d& wo, const Vec3d& wi, const OfDirections& f) {
  // Some ten roundings of components up to 1: of the direction, of the frame, of a sum and its length.
  // Lengths too are rounded, which tilts a grazing facet.
  constexpr double kStep = 12.0 * kFloatRounding;
  const double here = f(wo, wi);
  double change = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3d step(0.0);
      step[axis] = sign * kStep;
      change = std::max({change, std::abs(f(wo + step, wi) - here), std::abs(f(wo, wi + step) - here)});
    }
  }
  return 2.0 * change;
}

Failures checkDensity(BsdfBench& bench, const BsdfCase& c, std::size_t tests) {
  const Grid grid;
  std::vector<double> expected;
  double reflected = 0.0;
  double left = kDraws;
  for (const Chart& chart : c.charts) {
    for (const Vec2d& cell : integrals(grid, integrandOf(bench, c, chart), kTolerance)) {
      expected.push_back(cell.x * kDraws);
      left -= expected.back();
      reflected += cell.y;
    }
  }
  Failures failures;
  const double rounding = 1e-5 * kDraws;
  if (left < -rounding)
    failures.push_back(fmt::format("{}: the density's integral is {:.8g}", c.name, 1.0 - left / kDraws));
  expected.push_back(std::max(left, 0.0));
  std::vector<double> observed(expected.size());
  double sum = 0.0;
  double squares = 0.0;
  for (const BsdfDraw& d : bench.probe.sampleBsdf(c.view, kDraws, seedOf(c.name))) {
    const double weight = meanChannel(Vec3d(d.weight));
    sum += weight;
    squares += weight * weight;
    observed[d.scatters() ? cellOf(c, grid, Vec3d(d.wi)) : observed.size() - 1] += 1.0;
  }
  // What is left over is too little to count where the lobe lies all above the surface.
  if (expected.back() < rounding && observed.back() <= rounding)
    expected.back() = observed.back() = 0.0;
  const ChiSquare result = chiSquare(observed, expected);
  if (!(result.probability > kFamilyAlpha / static_cast<double>(2 * tests)))
    failures.push_back(fmt::format("{}: {}", c.name, result.figures()));

  const double mean = sum / kDraws;
  const double error = std::sqrt(std::max(squares / kDraws - mean * mean, 0.0) / kDraws);
  const double bound = sidakBound(2 * tests) * error + 1e-5 * reflected; // and the quadrature's error
  if (!(std::abs(mean - reflected) <= bound)) {
    failures.push_back(fmt::format("{}: mean weight {:.7g} +- {:.2g}, the integral of f cos is {:.7g}",
                                   c.name, mean, error, reflected));
  }
  return failures;
}

Failures checkWeights(BsdfBench& bench, const BsdfCase& c) {
  const Vec3d n = normalOf(c.view);
  const Vec3d wo = glm::normalize(Vec3d(c.view.wo));
  const auto density = [&](const Vec3d& o, const Vec3d& i) {
    return bench.oracle.evaluate(c.view, o, i).pdf_w;
  };
  const auto weightOf = [&](const Vec3d& o, const Vec3d& i) {
    const OracleValue value = bench.oracle.evaluate(c.view, o, i);
    return value.pdf_w > 0.0 ? meanChannel(value.f) * std::abs(glm::dot(n, i)) / value.pdf_w : 0.0;
  };
  for (const BsdfDraw& d : bench.probe.sampleBsdf(c.view, kCompared, seedOf(c.name + " weights"))) {
    const Vec3d wi = glm::normalize(Vec3d(d.wi));
    if (!isFinite(d) || (d.scatters() && !(d.pdf_w > 0.0F)))
      return {fmt::format("{}: a draw of density {:g} and weight {:g}", c.name, d.pdf_w, d.weight.x)};
    if (!d.scatters())
      continue;
    const double pdf = density(wo, wi);
    const double weight = weightOf(wo, wi);
    if (differ(static_cast<double>(d.pdf_w), pdf, roundingOf(wo, wi, density)))
      return {fmt::format("{}: density {:.8g}, in double {:.8g}", c.name, d.pdf_w, pdf)};
    if (differ(meanChannel(Vec3d(d.weight)), weight, roundingOf(wo, wi, weightOf))) {
      return {
          fmt::format("{}: weight {:.8g}, in double {:.8g}", c.name, meanChannel(Vec3d(d.weight)), weight)};
    }
  }
  return {};
}

Failures checkEvaluation(BsdfBench& bench, const BsdfCase& c) {
  std::mt19937 random(seedOf(c.name + " evaluation"));
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vec3f> directions;
  while (directions.size() < kCompared) {
    const double u = unit(random);
    const double v = unit(random);
    if (const auto wi = c.charts[directions.size() % c.charts.size()].direction(u, v))
      directions.emplace_back(*wi);
  }
  const std::vector<BsdfAnswer> answers = bench.probe.evaluateBsdf(c.view, directions);
  const Vec3d wo = glm::normalize(Vec3d(c.view.wo));
  const auto f = [&](const Vec3d& o, const Vec3d& i) {
    return meanChannel(bench.oracle.evaluate(c.view, o, i).f);
  };
  const auto pdf = [&](const Vec3d& o, const Vec3d& i) { return bench.oracle.evaluate(c.view, o, i).pdf_w; };
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Vec3d wi = glm::normalize(Vec3d(directions[i]));
    if (bench.oracle.evaluate(c.view, wi).pdf_w == 0.0)
      continue; // on the horizon
    if (differ(meanChannel(Vec3d(answers[i].f)), f(wo, wi), roundingOf(wo, wi, f)))
      return {
          fmt::format("{}: f {:.8g}, in double {:.8g}", c.name, meanChannel(Vec3d(answers[i].f)), f(wo, wi))};
    if (differ(static_cast<double>(answers[i].pdf_w), pdf(wo, wi), roundingOf(wo, wi, pdf)))
      return {fmt::format("{}: pdf {:.8g}, in double {:.8g}", c.name, answers[i].pdf_w, pdf(wo, wi))};
  }
  return {};
}

} // namespace vkpt::test
