// Fresnel, Phong, microfacets and the weights of two strategies, where float formulas break: on the device,
// row by row, against the same in double.
#include "selftest/case.h"
#include "selftest/functions.h"
#include "selftest/scene_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace vkpt::selftest {
namespace {

constexpr std::size_t kDraws = std::size_t{1} << 16U;

/// The largest of what was seen, and where; NaN stays.
class Worst {
public:
  void see(double value, const std::string& where) {
    if (value <= m_value || std::isnan(m_value))
      return;
    m_value = value;
    m_where = where;
  }
  [[nodiscard]] double value() const { return m_value; }
  [[nodiscard]] const std::string& where() const { return m_where; }

private:
  double m_value = 0.0;
  std::string m_where;
};

std::string fresnelText(const Row& x, double f) {
  return fmt::format("cos {:.9g}, index {:.9g}: {:.9g}", x.a[0], x.a[1], f);
}

/// 129 floats about the critical angle of glass: with three roundings sin^2 is off by 1.8e-7 at most, its
/// cosine by the root of that, and the share by 5.8 times as much.
void criticalAngle(Trial& t) {
  constexpr double kShareBound = 2.5e-3;
  constexpr float kEta = 1.0F / 1.5F;
  float cosine = static_cast<float>(std::sqrt(1.0 - double{kEta} * double{kEta}));
  for (int k = 0; k < 64; ++k)
    cosine = std::nextafter(cosine, 0.0F);
  std::vector<Row> rows;
  for (int k = -64; k <= 64; ++k) {
    rows.push_back({{cosine, kEta, 0.0F, 0.0F}, {}});
    cosine = std::nextafter(cosine, 1.0F);
  }
  const std::vector<Row> results = evaluate(t, Function::Dielectric, rows);
  Worst off, outside, rise, angle;
  double previous = 1.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double f = double{results[i].a[0]};
    const double cosI = double{rows[i].a[0]};
    const std::string where = fresnelText(rows[i], f);
    off.see(std::abs(f - exactFresnelDielectric(cosI, double{kEta})), where);
    outside.see(std::max(f - 1.0, -f), where);
    rise.see(f - previous, where);
    angle.see(std::abs(double{results[i].a[1]}), where); // a NaN shows
    previous = f;
  }
  t.atMost("share against double", off.value(), kShareBound, off.where());
  t.atMost("share outside of [0, 1]", outside.value(), 0.0, outside.where());
  t.atMost("share rises away from the angle by", rise.value(), 1e-6, rise.where());
  t.atMost("cosine beyond the boundary", angle.value(), 0.01, angle.where());
}

/// Where the equations are 0 / 0 or cancel, and everywhere else.
void fresnelEnds(Trial& t) {
  std::vector<Row> rows;
  for (const float cosine : {0.0F, 1e-30F, 1e-8F, 1.0F}) {
    for (const float eta : {1e-3F, 1.0F, 1.3F, 1.5F, 3.0F, 1e3F})
      rows.push_back({{cosine, eta, 0.0F, 0.0F}, {}});
  }
  const std::size_t ends = rows.size();
  std::mt19937 random(t.seed("fresnel"));
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  while (rows.size() < kDraws)
    rows.push_back({{unit(random), 1.0F + 2.0F * unit(random), 0.0F, 0.0F}, {}});
  const std::vector<Row> glass = evaluate(t, Function::Dielectric, rows);
  const std::vector<Row> metal = evaluate(t, Function::Conductor, rows);
  Worst end, off, sum, differ;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double cosine = double{rows[i].a[0]};
    const double eta = double{rows[i].a[1]};
    const double exact = eta == 1.0 ? 0.0 : exactFresnelDielectric(cosine, eta);
    const double f = double{glass[i].a[0]};
    (i < ends ? end : off).see(std::abs(f - exact), fresnelText(rows[i], f));
    if (i < ends)
      continue;
    sum.see(std::abs(f + double{glass[i].a[2]} - 1.0), fresnelText(rows[i], f));
    differ.see(std::abs(double{metal[i].a[0]} - exact), fresnelText(rows[i], double{metal[i].a[0]}));
  }
  t.atMost("at grazing, head-on, equal indices", end.value(), 1e-6, end.where());
  t.atMost("65 536 random angles and indices", off.value(), 1e-6, off.where());
  t.atMost("reflected + transmitted - 1", sum.value(), 2e-6, sum.where());
  t.atMost("metal without absorption against glass", differ.value(), 1e-4, differ.where());
}

/// Values of Mitsuba's tests of its Fresnel functions.
void fresnelSpots(Trial& t) {
  struct Spot {
    double degrees;
    float eta;
    double share;
  };
  const auto half = [](double s, double p) { return 0.5 * (s * s + p * p); };
  const Spot spots[] = {{45.0, 1.5F, half(0.0920134, 0.3033370)},
                        {10.0, 1.0F / 1.5F, half(0.1904680, 0.2094943)},
                        {56.3099325, 1.5F, half((1.0 - 2.25) / (1.0 + 2.25), 0.0)}}; // Brewster: no p
  std::vector<Row> rows;
  for (const Spot& s : spots)
    rows.push_back(
        {{static_cast<float>(std::cos(s.degrees * std::numbers::pi / 180.0)), s.eta, 0.0F, 0.0F}, {}});
  const std::vector<Row> results = evaluate(t, Function::Dielectric, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    t.atMost(fmt::format("index {:.3g} at {:.4g} degrees", spots[i].eta, spots[i].degrees),
             std::abs(double{results[i].a[0]} - spots[i].share), 1e-6,
             fmt::format("{:.8g}, expected {:.8g}", results[i].a[0], spots[i].share));
  }
}

constexpr float kExponents[] = {0.0F, 1.0F, 50.0F, 1e3F, 1e6F};

/// The lobe about the normal, seen head-on: the sampled angle by its own random number, and the lobe's value
/// there.
void phongExponents(Trial& t) {
  for (const float n : kExponents) {
    std::vector<Row> rows;
    std::mt19937 random(t.seed(fmt::format("phong {}", n)));
    for (std::size_t i = 0; i < kDraws / 16; ++i) {
      // Every size of number there is, 0 and the one before 1 among them.
      const double spread =
          std::ldexp(1.0 + static_cast<double>(random() >> 9U) * 0x1p-23, -1 - static_cast<int>(i % 23));
      const double u = i == 0 ? 0.0 : i == 1 ? 1.0 - 0x1p-24 : spread;
      const auto quantised = static_cast<float>(std::floor(u * 0x1p24) * 0x1p-24);
      rows.push_back({{0.0F, 0.0F, 1.0F, n}, {quantised, 0.3F, 0.0F, 0.0F}});
    }
    const std::vector<Row> results = evaluate(t, Function::PhongSample, rows);
    Worst sine, lobe;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Vec3d wi(results[i].a[0], results[i].a[1], results[i].a[2]);
      const double logCos = std::log1p(-double{rows[i].b[0]}) / (double{n} + 1.0);
      const double exact2 = -std::expm1(2.0 * logCos);
      const std::string where = fmt::format("u = {:.9g}", rows[i].b[0]);
      // The tangent's square: unit length plays no part in it.
      const double sine2 = (wi.x * wi.x + wi.y * wi.y) / glm::dot(wi, wi);
      sine.see(exact2 == 0.0 ? sine2 : std::abs(std::sqrt(sine2 / exact2) - 1.0), where);
      const Vec3d apart = wi - Vec3d(0.0, 0.0, 1.0);
      const double versine = 0.5 * glm::dot(apart, apart);
      const double f = (double{n} + 2.0) / (2.0 * std::numbers::pi) *
                       std::exp(double{n} * std::log1p(-std::min(versine, 1.0)));
      if (f > 1e-12)
        lobe.see(std::abs(double{results[i].b[0]} / f - 1.0), where);
    }
    t.atMost(fmt::format("n = {:g}: sine of the sampled angle, relative", n), sine.value(), 1e-3,
             sine.where());
    t.atMost(fmt::format("n = {:g}: value of the lobe, relative", n), lobe.value(), 1e-3, lobe.where());
  }
}

/// Rough metal that absorbs next to nothing, from mirror-like to rough: no sample gains energy, the density
/// is that of GGX, and the smoother, the closer to the mirror.
void roughnessToMirror(Trial& t) {
  for (const float alpha : {1e-4F, 1e-3F, 1e-2F, 0.1F, 1.0F}) {
    std::vector<Row> rows;
    std::mt19937 random(t.seed(fmt::format("alpha {}", alpha)));
    for (std::size_t i = 0; i < kDraws / 16; ++i) {
      const double degrees = std::array{0.0, 45.0, 89.0}[i % 3];
      const double a = degrees * std::numbers::pi / 180.0;
      const auto unit = [&] { return static_cast<float>(random() >> 8U) * 0x1p-24F; };
      const float u = unit();
      rows.push_back({{static_cast<float>(std::sin(a)), 0.0F, static_cast<float>(std::cos(a)), alpha},
                      {u, unit(), i % 2 == 0 ? 0.0F : 1.0F, 0.0F}});
    }
    const std::vector<Row> results = evaluate(t, Function::RoughSample, rows);
    Worst weight, density, evaluated;
    double meanApart = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Vec3d wo(rows[i].a[0], rows[i].a[1], rows[i].a[2]);
      const Vec3d wi(results[i].a[0], results[i].a[1], results[i].a[2]);
      const std::string where = fmt::format("row {}", i);
      weight.see(double{results[i].b[0]}, where);
      const double pdf = double{results[i].a[3]};
      t.expect(std::isfinite(pdf) && (pdf > 0.0 || results[i].b[0] == 0.0F), "a density that is not above 0");
      meanApart += glm::length(wi - Vec3d(-wo.x, -wo.y, wo.z)) / static_cast<double>(rows.size());
      if (wo.z == 1.0 && rows[i].b[2] == 0.0F) {
        const Vec3d h = wi + wo;
        const double a2 = double{alpha} * double{alpha};
        const double sin2 = (h.x * h.x + h.y * h.y) / glm::dot(h, h);
        const double ggx = 1.0 - sin2 + sin2 / a2;
        const double exact = 1.0 / (4.0 * std::numbers::pi * a2 * ggx * ggx);
        if (sin2 > 0.0 && wi.z > 0.0) {
          density.see(std::abs(pdf / exact - 1.0), where);
          evaluated.see(std::abs(double{results[i].b[1]} / exact - 1.0), where);
        }
      }
    }
    t.atMost(fmt::format("alpha {:g}: largest weight", alpha), weight.value(), 1.0 + 1e-5, weight.where());
    t.atMost(fmt::format("alpha {:g}: density of the sample, relative", alpha), density.value(), 5e-3,
             density.where());
    t.atMost(fmt::format("alpha {:g}: density evaluated, relative", alpha), evaluated.value(), 5e-3,
             evaluated.where());
    if (alpha <= 1e-2F)
      t.atMost(fmt::format("alpha {:g}: mean distance from the mirror", alpha), meanApart,
               10.0 * double{alpha});
  }
}

/// From 1e-30 to 1e30 and at equal densities.
void strategyWeights(Trial& t) {
  std::vector<Row> rows;
  for (const auto& [p, q] : {std::pair{1e30F, 1e30F},
                             {1e-30F, 1e-30F},
                             {1e30F, 1.0F},
                             {1.0F, 1e30F},
                             {1.0F, 0.0F},
                             {1e20F, 1e20F},
                             {1e30F, 1e-8F},
                             {1e-30F, 1e8F}})
    rows.push_back({{p, q, 0.0F, 0.0F}, {}});
  std::mt19937 random(t.seed("weights"));
  std::uniform_real_distribution<float> exponent(-30.0F, 30.0F);
  while (rows.size() < 4096) {
    const float p = std::pow(10.0F, exponent(random));
    rows.push_back({{p, std::pow(10.0F, exponent(random)), 0.0F, 0.0F}, {}});
  }
  const std::vector<Row> results = evaluate(t, Function::MisWeight, rows);
  Worst off;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double ratio = double{rows[i].a[1]} / double{rows[i].a[0]};
    off.see(std::abs(double{results[i].a[0]} - 1.0 / (1.0 + ratio * ratio)),
            fmt::format("densities {:g} and {:g}: {:g}", rows[i].a[0], rows[i].a[1], results[i].a[0]));
  }
  t.atMost("weight against double", off.value(), 1e-6, off.where());
}

constexpr Case kFormulaCases[] = {
    {"d1-critical-angle", "Fresnel's share is finite, in [0, 1] and monotone 64 floats either side of it",
     criticalAngle},
    {"d2-fresnel-ends",
     "Fresnel's share at grazing, head-on and equal indices, and everywhere, against double", fresnelEnds},
    {"d3-fresnel-spots", "Fresnel's share at the angles that Mitsuba's tests look at", fresnelSpots},
    {"d10-phong-exponents",
     "Phong's lobe is sampled and evaluated to a thousandth for exponents from 0 to 1e6", phongExponents},
    {"d11-rough-to-mirror", "rough metal down to alpha 1e-4 makes no energy and comes close to a mirror",
     roughnessToMirror},
    {"d12-strategy-weights", "the power heuristic for densities from 1e-30 to 1e30", strategyWeights},
};

} // namespace

std::span<const Case> formulaCases() { return kFormulaCases; }

} // namespace vkpt::selftest
