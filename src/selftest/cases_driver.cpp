// What a driver does to shaders in silence, and that the style of our kernels is safe from it; and how
// precise its arithmetic is, against what the library's bounds take for granted.
#include "selftest/case.h"
#include "selftest/functions.h"
#include "selftest/shaders.h"
#include "selftest/small_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace vkpt::selftest {
namespace {

constexpr std::size_t kLanes = 64;

using LoopState = std::array<std::uint32_t, 4>; // outer, inner, count, unused

std::vector<LoopState> runLoop(const Trial& t, const std::vector<LoopState>& before, std::uint32_t budget) {
  std::vector<LoopState> after(before.size());
  runSmallProgram(t.context(), {spirv::kLoopLimit, {{0U, budget}}}, std::as_bytes(std::span{before}),
                  std::as_writable_bytes(std::span{after}));
  return after;
}

/// lavapipe cuts all loops of a subgroup together after 65 535 iterations: 1000 x 100 come out short. With a
/// budget below that, and dispatch after dispatch, as path.comp does it, they come out right.
void loopLimit(Trial& t) {
  constexpr std::uint32_t kIterations = 1000 * 100;
  constexpr std::uint32_t kBudget = 24000;
  constexpr std::uint32_t kNoBudget = 0xFFFFFFFFU;
  const auto naive = runLoop(t, std::vector<LoopState>(kLanes), kNoBudget);
  const auto counted = std::ranges::max(naive, {}, [](const LoopState& s) { return s[2]; })[2];
  t.note("iterations of 100000 without a budget", counted);
  std::vector<LoopState> state(kLanes);
  std::uint32_t dispatches = 0;
  while (std::ranges::any_of(state, [](const LoopState& s) { return s[0] < 1000; }) && dispatches < 100) {
    state = runLoop(t, state, kBudget);
    ++dispatches;
  }
  t.expect(dispatches == (kIterations + kBudget - 1) / kBudget, fmt::format("{} dispatches", dispatches));
  double wrong = 0.0;
  for (const LoopState& s : state)
    wrong += s[2] == kIterations ? 0.0 : 1.0;
  t.atMost("lanes that counted wrong under a budget", wrong, 0.0);
}

struct Kept {
  std::uint32_t afterLoop;
  std::uint32_t insideLoop;
};

/// Lane n leaves a loop in round n with the value it has just loaded. Read after the loop it may be wrong:
/// lanes get what the last lane loaded. Stored before the break, as our kernels do, it is right.
void divergentBreak(Trial& t) {
  std::vector<std::uint32_t> data(kLanes * kLanes);
  for (std::uint32_t i = 0; i < data.size(); ++i)
    data[i] = 1000 + i;
  std::vector<Kept> kept(kLanes);
  runSmallProgram(t.context(), {spirv::kDivergence}, std::as_bytes(std::span{data}),
                  std::as_writable_bytes(std::span{kept}));
  double inside = 0.0;
  double after = 0.0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const std::uint32_t right = data[lane * kLanes + lane];
    inside += kept[lane].insideLoop == right ? 0.0 : 1.0;
    after += kept[lane].afterLoop == right ? 0.0 : 1.0;
  }
  t.note("lanes of 64 that are wrong when read after the loop", after);
  t.atMost("lanes that are wrong when stored in it", inside, 0.0);
}

/// A function of the device's arithmetic, and the error it may have.
struct Precision {
  const char* name;
  std::size_t part; // of the result: a[0..3], b[0..3]
  double (*exact)(const Row&);
  double ulps;     ///< of the result, or
  double absolute; ///< where that is larger
};

double arg(const Row& x, std::size_t i) { return double{x.a.at(i)}; }

/// Arguments: a.x from 1e-6 to 1e6, a.y from 0.1 to 10 (divisor, exponent), a.z in [-20, 20], a.w in [-pi,
/// pi]. Vulkan allows 2.5 ulp for a division, 3 + 2 |x| for exp, 2^-11 for a sine, the inherited error of
/// exp2 and log2 for pow; sqrt has that of 1 / inversesqrt. The library asks for less than that where it says
/// so.
constexpr Precision kPrecisions[] = {
    {"division", 0, [](const Row& x) { return arg(x, 0) / arg(x, 1); }, 2.5, 0.0},
    {"square root", 1, [](const Row& x) { return std::sqrt(arg(x, 0)); }, 3.0, 0.0},
    {"exp", 2, [](const Row& x) { return std::exp(arg(x, 2)); }, 3.0 + 2.0 * 20.0, 0.0},
    {"log", 3, [](const Row& x) { return std::log(arg(x, 0)); }, 4.0, 0x1p-21},
    {"sin", 4, [](const Row& x) { return std::sin(arg(x, 3)); }, 0.0, 0x1p-11},
    {"cos", 5, [](const Row& x) { return std::cos(arg(x, 3)); }, 0.0, 0x1p-11},
    {"atan of two", 6, [](const Row& x) { return std::atan2(arg(x, 2), arg(x, 3)); }, 4096.0, 0.0},
    {"pow", 7, [](const Row& x) { return std::pow(arg(x, 0), arg(x, 1)); }, 16.0 + 2.0 * 140.0, 0.0},
};

void precision(Trial& t) {
  std::mt19937 random(t.seed("precision"));
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  std::vector<Row> rows(std::size_t{1} << 14U);
  for (Row& r : rows) {
    r.a = {std::pow(10.0F, 12.0F * unit(random) - 6.0F), std::pow(10.0F, 2.0F * unit(random) - 1.0F),
           40.0F * unit(random) - 20.0F, static_cast<float>(std::numbers::pi) * (2.0F * unit(random) - 1.0F)};
  }
  const std::vector<Row> results = evaluate(t, Function::Arithmetic, rows);
  for (const Precision& p : kPrecisions) {
    double ulps = 0.0;
    double absolute = 0.0;
    double share = 0.0; // of what is allowed
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const float value = p.part < 4 ? results[i].a.at(p.part) : results[i].b.at(p.part - 4);
      const double exact = p.exact(rows[i]);
      if (std::abs(exact) > double{std::numeric_limits<float>::max()} ||
          std::abs(exact) < double{std::numeric_limits<float>::min()})
        continue; // may be infinite, may be 0
      const double off = std::abs(double{value} - exact);
      const double inUlps = ulpsOff(value, exact);
      ulps = std::max(ulps, inUlps);
      absolute = std::max(absolute, off);
      const bool within = inUlps <= p.ulps || off <= p.absolute;
      share = std::max(share, within ? 0.0 : 1.0);
    }
    const std::string detail = fmt::format("at most {:.3g} ulp, {:.3g} absolute", ulps, absolute);
    t.note(fmt::format("{}: largest error, ulp", p.name), ulps, detail);
    t.atMost(fmt::format("{}: results beyond what Vulkan allows", p.name), share, 0.0, detail);
  }
}

/// What a NaN does in min, max and clamp is a driver's choice; the library must tell it by its bits, and its
/// slab test treats distances, never NaN.
void notANumber(Trial& t) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<Row> rows{{{nan, 1.0F, 0.0F, 0.0F}, {}},      {{1.0F, nan, 0.0F, 0.0F}, {}},
                              {{infinity, 2.0F, 0.0F, 0.0F}, {}}, {{-infinity, 2.0F, 0.0F, 0.0F}, {}},
                              {{0.25F, 0.5F, 0.0F, 0.0F}, {}},    {{0.0F, 3e30F, 0.0F, 0.0F}, {}}};
  const std::vector<Row> r = evaluate(t, Function::Extremes, rows);
  t.note("min(NaN, 1)", double{r[0].a[0]});
  t.note("min(1, NaN)", double{r[1].a[0]});
  t.note("max(NaN, 1)", double{r[0].a[1]});
  t.note("max(1, NaN)", double{r[1].a[1]});
  t.note("clamp(NaN, 0, 1)", double{r[0].a[2]});
  t.note("NaN == NaN", double{r[0].b[3]});
  t.expect(r[0].b[2] == 0.0F, "isFinite(NaN)");
  t.expect(r[2].b[2] == 0.0F && r[3].b[2] == 0.0F, "isFinite(infinity)");
  t.expect(r[1].b[2] == 1.0F && r[4].b[2] == 1.0F && r[5].b[2] == 1.0F, "isFinite of numbers");
  t.expect(r[4].b[0] == 0.25F && r[4].b[1] == 0.5F, "slab test: 0.25 and 0.5");
  t.expect(r[5].b[0] == 0.0F && r[5].b[1] == 3e30F, "slab test: 0 and 3e30");
  t.expect(r[2].b[0] == 2.0F && r[2].b[1] == infinity, "slab test: infinity");
}

/// Whether numbers below 2^-126 are kept or become 0; either will do, but a zero must stay one and what is
/// kept must be right.
void denormals(Trial& t) {
  const float least = std::numeric_limits<float>::denorm_min();
  const float half = 0x1p-127F;
  const float normal = std::numeric_limits<float>::min();
  const std::vector<Row> rows{{{half, half, 0.0F, 0.0F}, {}},
                              {{least, 0.0F, 0.0F, 0.0F}, {}},
                              {{normal, 0.5F, 0.0F, 0.0F}, {}},
                              {{0.0F, 0.0F, 0.0F, 0.0F}, {}}};
  const std::vector<Row> r = evaluate(t, Function::Denormals, rows);
  t.note("2^-127 + 2^-127 over 2^-126 (1: kept)", double{r[0].a[0]} / double{normal});
  t.note("2^-126 / 2 over 2^-127 (1: kept)", double{r[2].a[1]} / double{half});
  t.note("2^-149 > 0 (1: kept)", double{r[1].a[3]});
  t.expect(r[0].a[0] == 0.0F || r[0].a[0] == normal, "2^-127 + 2^-127 is neither 0 nor 2^-126");
  t.expect(r[2].a[1] == 0.0F || r[2].a[1] == half, "2^-126 / 2 is neither 0 nor 2^-127");
  t.expect(r[3].a[0] == 0.0F && r[3].a[3] == 0.0F, "0 is not 0");
}

/// x y - z w: contracted to a fused multiply-add it is neither antisymmetric nor 0 for equal products. Edge
/// functions must be both, and the two halves of a product exact.
void contraction(Trial& t) {
  std::mt19937 random(t.seed("contraction"));
  std::uniform_real_distribution<float> unit(0.5F, 1.0F);
  std::vector<Row> rows(std::size_t{1} << 14U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const float x = unit(random);
    const float y = unit(random);
    rows[i].a = {x, y, i % 2 == 0 ? x : unit(random), i % 2 == 0 ? y : unit(random)};
  }
  const std::vector<Row> results = evaluate(t, Function::Contraction, rows);
  double fused = 0.0;
  double asymmetric = 0.0;
  double notZero = 0.0;
  double inexact = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [loose, forth, back, unused] = results[i].a;
    fused += i % 2 == 0 && loose != 0.0F ? 1.0 : 0.0;
    notZero += i % 2 == 0 && forth != 0.0F ? 1.0 : 0.0;
    asymmetric += forth == -back ? 0.0 : 1.0;
    const double product = arg(rows[i], 0) * arg(rows[i], 1); // 48 bits: exact
    inexact += double{results[i].b[0]} + double{results[i].b[1]} == product ? 0.0 : 1.0;
  }
  t.note("plain x y - x y that are not 0 (contracted), of 8192", fused);
  t.atMost("edge functions of equal products that are not 0", notZero, 0.0);
  t.atMost("edge functions that are not antisymmetric", asymmetric, 0.0);
  t.atMost("products of two halves that are not exact", inexact, 0.0);
}

/// GLSL leaves pow undefined for x < 0, and for x = 0 with y <= 0: what the driver says is told, and what it
/// defines must hold.
void powerEdges(Trial& t) {
  const std::vector<Row> rows{{{0.0F, 0.0F, 0.0F, 0.0F}, {}}, {{-1.0F, 2.0F, 0.0F, 0.0F}, {}},
                              {{0.0F, 3.0F, 0.0F, 0.0F}, {}}, {{1.0F, 1e6F, 0.0F, 0.0F}, {}},
                              {{0.5F, 1e6F, 0.0F, 0.0F}, {}}, {{2.0F, 0.0F, 0.0F, 0.0F}, {}}};
  const std::vector<Row> r = evaluate(t, Function::Powers, rows);
  t.note("pow(0, 0)", double{r[0].a[0]});
  t.note("pow(-1, 2)", double{r[1].a[0]});
  t.note("log(0)", double{r[0].a[2]});
  t.expect(r[2].a[0] == 0.0F, "pow(0, 3) is not 0");
  t.expect(r[3].a[0] == 1.0F, "pow(1, 1e6) is not 1");
  t.expect(r[4].a[0] == 0.0F, "pow(0.5, 1e6) is not 0");
  t.expect(r[5].a[0] == 1.0F, "pow(2, 0) is not 1");
  t.expect(r[0].a[3] == 0.0F, "sqrt(0) is not 0");
}

constexpr Case kDriverCases[] = {
    {"t-loop-limit", "loops under a budget are not cut, whatever the driver's limit", loopLimit},
    {"t-divergent-break", "a value stored before a divergent break is the lane's own", divergentBreak},
    {"t-precision", "division, roots, exp, log, sin, cos, atan and pow are as precise as Vulkan promises",
     precision},
    {"t-nan", "NaN and infinity are told by their bits; distances are ordered by theirs", notANumber},
    {"t-denormals", "numbers below the least normal one are kept or 0", denormals},
    {"t-contraction", "edge functions and exact products are not contracted", contraction},
    {"t-power-edges", "pow where it is defined", powerEdges},
};

} // namespace

std::span<const Case> driverCases() { return kDriverCases; }

} // namespace vkpt::selftest
