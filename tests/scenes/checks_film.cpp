// The film's sums against the same sums in long double.
#include "scenes/check.h"

#include "scenes/merge_program.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <random>

namespace vkpt::test {
namespace {

struct Direct {
  long double mean = 0.0L;
  long double m2 = 0.0L;
};
Direct momentsOf(const std::vector<double>& x) {
  Direct d;
  for (const double v : x)
    d.mean += v;
  d.mean /= static_cast<long double>(x.size());
  for (const double v : x)
    d.m2 += (v - d.mean) * (v - d.mean);
  return d;
}

/// Sample `index` of every pixel, from a film that holds it alone. Number n of a group joins a mean of 0 in
/// an empty film, which makes it 1/n of itself.
std::vector<Vec3d> sampleAlone(Integrator& integrator, std::uint64_t index) {
  integrator.clear();
  integrator.renderTile({0, integrator.blockCount()}, index, 1);
  const double n = static_cast<double>(index % shared::kSamplesPerGroup + 1);
  std::vector<Vec3d> samples;
  for (const PixelMoments& p : integrator.film().pixels)
    samples.push_back(p.mean * n);
  return samples;
}

/// What 40 frames leave in the film, against the 40 samples of each pixel taken one by one. A group of 16
/// float additions of squares loses at most 16 roundings relative to their sum.
void filmOfSamples(Trial& t) {
  constexpr std::uint64_t kFrames = 40;
  constexpr double kTolerance = 16.0 * 0x1p-24;
  RenderSetup setup{.estimator = lightSampling(), .width = 8, .height = 8, .frames = kFrames};
  setup = t.complete(setup);
  const Scene scene = twoLightRoom();
  Studio studio(t.context(), scene, setup);
  const Film film = studio.render().film;
  std::vector<std::vector<Vec3d>> samples;
  for (std::uint64_t i = 0; i < kFrames; ++i)
    samples.push_back(sampleAlone(studio.integrator(), i));
  for (std::size_t p = 0; p < film.pixels.size(); ++p) {
    for (int c = 0; c < 3; ++c) {
      std::vector<double> x;
      for (const auto& frame : samples)
        x.push_back(frame[p][c]);
      const Direct d = momentsOf(x);
      const double meanError = std::abs(film.pixels[p].mean[c] - static_cast<double>(d.mean));
      const double m2Error = std::abs(film.pixels[p].m2[c] - static_cast<double>(d.m2));
      const double size = static_cast<double>(d.mean) + std::sqrt(static_cast<double>(d.m2) / kFrames);
      if (meanError <= kTolerance * size && m2Error <= kTolerance * static_cast<double>(d.m2))
        continue;
      t.expect(false, fmt::format("pixel {} channel {}: mean {:.9g}, m2 {:.9g}; expected {:.9g}, {:.9g}", p,
                                  c, film.pixels[p].mean[c], film.pixels[p].m2[c],
                                  static_cast<double>(d.mean), static_cast<double>(d.m2)));
      return;
    }
  }
}

/// Two of each pixel's samples are never the same, and differ between pixels.
void samplesDiffer(Trial& t) {
  const Film film =
      t.render(twoLightRoom(), {.estimator = lightSampling(), .width = 16, .height = 16, .frames = 8}).film;
  std::size_t still = 0;
  for (const PixelMoments& p : film.pixels)
    still += p.m2 == Vec3d(0.0) ? 1U : 0U;
  t.expect(still < film.pixels.size() / 20, fmt::format("{} of 256 pixels have no variance", still));
}

/// mergeGroup() on the device: groups of known moments, 1000 of them, in 64 streams.
void mergedGroups(Trial& t) {
  constexpr std::size_t kGroups = 1000;
  std::mt19937_64 random(seedOf("mergedGroups"));
  std::normal_distribution<float> spread(0.0F, 0.01F);
  std::vector<GroupMoments> groups(kGroups * kMergeStreams);
  for (GroupMoments& g : groups) // a mean far from 0, so that float or cancelling sums would show
    g = {1000.0F + spread(random), std::abs(spread(random)) * 0.01F};
  const std::vector<PairMoments> merged = mergeOnDevice(groups, t.kernel().mutation);
  constexpr auto n = static_cast<long double>(shared::kSamplesPerGroup);
  for (std::size_t s = 0; s < kMergeStreams; ++s) {
    long double mean = 0.0L;
    for (std::size_t g = 0; g < kGroups; ++g)
      mean += static_cast<long double>(groups[g * kMergeStreams + s].mean) / kGroups;
    long double m2 = 0.0L;
    for (std::size_t g = 0; g < kGroups; ++g) {
      const GroupMoments& x = groups[g * kMergeStreams + s];
      m2 += x.deviations + n * (x.mean - mean) * (x.mean - mean);
    }
    // Pairs hold about 48 bits; 1000 merges lose a few of them.
    const double meanError = std::abs(merged[s].mean() - static_cast<double>(mean)) / 1000.0;
    const double m2Error = std::abs(merged[s].deviations() / static_cast<double>(m2) - 1.0);
    if (meanError < 1e-12 && m2Error < 1e-9)
      continue;
    t.expect(false, fmt::format("stream {}: mean {:.12g}, m2 {:.12g}; expected {:.12g}, {:.12g}", s,
                                merged[s].mean(), merged[s].deviations(), static_cast<double>(mean),
                                static_cast<double>(m2)));
    return;
  }
}

/// Groups of one constant: its mean, to the last bit, and deviations of exactly 0.
void mergedConstant(Trial& t) {
  const std::vector<GroupMoments> groups(5000 * kMergeStreams, GroupMoments{0.1F, 0.0F});
  for (const PairMoments& m : mergeOnDevice(groups, t.kernel().mutation)) {
    if (m.mean() == static_cast<double>(0.1F) && m.deviations() == 0.0)
      continue;
    t.expect(false, fmt::format("mean {:.17g}, deviations {:g} of the constant {:.17g}", m.mean(),
                                m.deviations(), static_cast<double>(0.1F)));
    return;
  }
}

constexpr Check kFilmChecks[] = {
    {"mergedGroups", mergedGroups},
    {"mergedConstant", mergedConstant},
    {"samplesDiffer", samplesDiffer},
    {"filmOfSamples", filmOfSamples},
};

} // namespace

std::span<const Check> filmChecks() { return kFilmChecks; }

} // namespace vkpt::test
