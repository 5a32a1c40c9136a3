// The film's sums over more samples than a float can count.
#include "selftest/case.h"
#include "selftest/shaders.h"
#include "selftest/small_program.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace vkpt::selftest {
namespace {

constexpr std::uint32_t kGroupsConstant = 100; // constant_id of kGroups
constexpr std::uint32_t kGroups = 2048;        // a dispatch: below the loop limit
constexpr std::uint32_t kLogSamples = 26;      // of a stream
constexpr std::uint64_t kSamples = std::uint64_t{1} << kLogSamples;
constexpr std::size_t kStreams = 4; // of eight lanes: the others are copies with other numbers
constexpr std::array<const char*, kStreams> kNames{"constant", "uniform", "uniform about 1000.5",
                                                   "rare and large"};

struct Stream { // probe/sums.comp
  std::array<float, 4> moments;
  std::array<std::uint32_t, 4> count;
};

std::uint32_t firstOfPcg4d(std::uint32_t x, std::uint32_t y) {
  std::array<std::uint32_t, 4> v{x, y, 0, 0};
  for (std::uint32_t& c : v)
    c = c * 1664525U + 1013904223U;
  const auto mix = [&v] {
    v[0] += v[1] * v[3];
    v[1] += v[2] * v[0];
    v[2] += v[0] * v[1];
    v[3] += v[1] * v[2];
  };
  mix();
  for (std::uint32_t& c : v)
    c ^= c >> 16U;
  mix();
  return v[0];
}

float valueOf(std::size_t stream, std::uint32_t i) {
  const float u = static_cast<float>(firstOfPcg4d(i, static_cast<std::uint32_t>(stream)) >> 8U) * 0x1p-24F;
  switch (stream) {
  case 1:
    return u;
  case 2:
    return 1000.0F + u;
  case 3:
    return u < 0.001F ? 500.0F : 0.25F;
  default:
    return 0.1F;
  }
}

struct Exact {
  double mean = 0.0;
  double deviations = 0.0;
};

/// In long double, about the first number: nothing cancels in 64 bits.
Exact momentsOf(std::size_t stream) {
  const auto about = static_cast<long double>(valueOf(stream, 0));
  long double sum = 0.0L;
  long double squares = 0.0L;
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    const long double x = static_cast<long double>(valueOf(stream, static_cast<std::uint32_t>(i))) - about;
    sum += x;
    squares += x * x;
  }
  const auto n = static_cast<long double>(kSamples);
  return {static_cast<double>(about + sum / n), static_cast<double>(squares - sum * sum / n)};
}

void longStreams(Trial& t) {
  std::array<Stream, 8> streams{};
  gpu::SpecialisationMap constants = t.kernel().constants();
  constants[kGroupsConstant] = kGroups;
  const auto repeats = static_cast<std::uint32_t>(kSamples / shared::kSamplesPerGroup / kGroups);
  const std::array<std::uint32_t, 4> unused{};
  runSmallProgram(t.context(), {t.kernel().of(spirv::kSums), constants, 0, 1, repeats},
                  std::as_bytes(std::span{unused}), std::as_writable_bytes(std::span{streams}));
  for (std::size_t s = 0; s < kStreams; ++s) {
    const auto& m = streams.at(s).moments;
    const double mean = double{m[0]} + double{m[1]};
    const double deviations = double{m[2]} + double{m[3]};
    const Exact exact = momentsOf(s);
    t.expect(streams.at(s).count[0] == kSamples / shared::kSamplesPerGroup, "not every group was added");
    t.atMost(fmt::format("{}: mean, relative", kNames.at(s)), std::abs(mean / exact.mean - 1.0),
             s == 0 ? 0.0 : 1e-6, fmt::format("{:.12g}, expected {:.12g}", mean, exact.mean));
    if (s == 0)
      t.atMost("constant: squared deviations", std::abs(deviations), 0.0);
    else
      t.atMost(fmt::format("{}: squared deviations, relative", kNames.at(s)),
               std::abs(deviations / exact.deviations - 1.0), 1e-6,
               fmt::format("{:.12g}, expected {:.12g}", deviations, exact.deviations));
  }
}

constexpr Case kSumCases[] = {
    {"m5-accumulation", "2^26 samples of known streams: means and variances to 1e-6, a constant exactly",
     longStreams},
};

} // namespace

std::span<const Case> sumCases() { return kSumCases; }

} // namespace vkpt::selftest
