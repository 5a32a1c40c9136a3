#pragma once
// Paths vertex by vertex: as the device walks them in float, and as the host does in double.

#include "host/replay.h"
#include "probe/path_records.h"
#include "selftest/trial.h"

namespace vkpt::selftest {

/// A scene as both programs read it.
struct OracleScene {
  Scene scene;
  HostSettings settings;
  EffectSet effects;
  PackedScene packed;
};
/// width x height paths a sample; `scene` as it is rendered by default but for the settings given.
OracleScene oracleScene(const Scene& scene, const EstimatorSettings& estimator, int width, int height,
                        std::uint32_t seed);

/// Sample number `sample` of every pixel, row by row, by the trial's kernel. No split paths.
std::vector<shared::PathRecord> recordPaths(const Trial& t, const OracleScene& scene, std::uint32_t sample);

/// Where two programs' paths first part.
enum class Parting {
  None,     ///< the same decisions throughout
  Triangle, ///< the same ray met something else
  Lobe,     ///< it was sent another way: another lobe, or reflected here and refracted there
  Roulette, ///< one went on, the other ended
  Shadow,   ///< direct light was seen by one only
};
/// Radiance below `least` counts as none: in float it may underflow.
Parting partingOf(const shared::PathRecord& device, const Replay& host, double least);

} // namespace vkpt::selftest
