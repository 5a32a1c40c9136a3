#pragma once
// The yardstick: the float build of the library with Embree behind its traversal, effects known at compile
// time, built with -O3 -march=native.

#include "embree_scene.h"
#include "host/reference.h"

namespace vkpt::bench {

/// Throws std::runtime_error for a set of effects that it was not compiled for.
HostRender renderYardstick(const PackedScene& scene, const EmbreeScene& embree, const Scene& source,
                           const EffectSet& effects, const HostSettings& settings, std::uint64_t frames);

RaySet recordRays(const PackedScene& scene, const EmbreeScene& embree, const Scene& source,
                  const EffectSet& effects, const HostSettings& settings);

} // namespace vkpt::bench
