#pragma once
// Renders on the host with the device's own estimator: in float, for sanitizers and debuggers, and in double,
// the oracle. Same random numbers, same paths.

#include "device/device_scene.h"
#include "device/effects.h"
#include "film/film.h"

#include <array>

namespace vkpt {

struct HostSettings {
  EstimatorSettings estimator;
  int width = 512;
  int height = 512;
  std::uint32_t seed = 0;
};

/// As the device's counters; faults are nonFinite, cutTraversal and invalidPdf.
struct HostCounters {
  std::uint64_t raysClosest = 0;
  std::uint64_t raysShadow = 0;
  std::uint64_t cappedPaths = 0;
  std::uint64_t nonFinite = 0;
  std::uint64_t cutTraversal = 0;
  std::uint64_t invalidPdf = 0;
  HostCounters& operator+=(const HostCounters& other);
  [[nodiscard]] std::uint64_t faults() const { return nonFinite + cutTraversal + invalidPdf; }
};

struct HostRender {
  Film film;
  HostCounters counters;
};

/// `frames` samples for every pixel of `source` at the settings' size. The result does not depend on
/// `threads`.
HostRender renderHost32(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                        const HostSettings& settings, std::uint64_t frames, unsigned threads = 1);
HostRender renderHost64(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                        const HostSettings& settings, std::uint64_t frames, unsigned threads = 1);

/// Mean radiance of each kind of light path in one pixel, over its first `samples` samples, and their sum.
struct HostPixel {
  std::array<Vec3d, kPathKindCount> kinds{};
  PixelMoments whole;
};
HostPixel renderPixel32(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                        const HostSettings& settings, int x, int y, std::uint64_t samples);

} // namespace vkpt
