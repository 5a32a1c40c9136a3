#pragma once
// Which naive version of the kernels each case of the self-test notices. Those that CI runs are quick.

#include "shared/mutations.h"

#include <cstdint>

namespace vkpt::test {

enum class Naive : std::uint32_t {
#define VKPT_ENUMERATOR(id, Name, what) Name = id,
  VKPT_MUTATIONS_LIST(VKPT_ENUMERATOR) VKPT_SAMPLING_MUTATIONS_LIST(VKPT_ENUMERATOR)
      VKPT_STABILITY_MUTATIONS_LIST(VKPT_ENUMERATOR) VKPT_GEOMETRY_MUTATIONS_LIST(VKPT_ENUMERATOR)
#undef VKPT_ENUMERATOR
};

struct Killer {
  const char* which; ///< the case
  std::uint32_t mutation;
  const char* name; ///< of the mutation
};
#define VKPT_KILLER(which, Name)                                                                             \
  { which, static_cast<std::uint32_t>(Naive::Name), #Name }

inline constexpr Killer kQuickKillers[] = {
    VKPT_KILLER("w2-rays-at-vertices-and-edges", LeakyTriangle),
    VKPT_KILLER("w2-rays-at-vertices-and-edges", BoxesMissedAside),
    VKPT_KILLER("w2-rays-at-vertices-and-edges", InfiniteInverse),
    VKPT_KILLER("o1-same-at-every-scale-and-place", AbsoluteOffset),
    VKPT_KILLER("o4-camera-in-a-corner", NaiveGeometry),
    VKPT_KILLER("o4-camera-in-a-corner", FrisvadFrame),
    VKPT_KILLER("o4-camera-in-a-corner", HitsUpToTheEdge),
    VKPT_KILLER("w9-faces-in-one-plane", TiesAtRandom),
    VKPT_KILLER("d1-critical-angle", RefractionUnclamped),
    VKPT_KILLER("d2-fresnel-ends", EqualIndicesUnguarded),
    VKPT_KILLER("d2-fresnel-ends", RefractionCancels),
    VKPT_KILLER("d3-fresnel-spots", FresnelOnePolarisation),
    VKPT_KILLER("d7-trapped-light", GlassAlwaysEntered),
    VKPT_KILLER("d8-white-furnace", RefractionScaled),
    VKPT_KILLER("d10-phong-exponents", PhongByPower),
    VKPT_KILLER("d10-phong-exponents", PhongSineCancels),
    VKPT_KILLER("d10-phong-exponents", PhongLogCancels),
    VKPT_KILLER("d11-rough-to-mirror", FacetSineCancels),
    VKPT_KILLER("d12-strategy-weights", WeightBySquares),
    VKPT_KILLER("m6-no-repeats", PixelKeyIsSum),
    VKPT_KILLER("m6-many-samples", SampleHighIgnored),
    VKPT_KILLER("m7-unit-interval", UnitMayBeOne),
    VKPT_KILLER("m8-correlation", PixelKeyIsSum),
    VKPT_KILLER("m14-extreme-colours", FaultsHidden),
    VKPT_KILLER("oracle-glossy", PhongNormalisation),
};

inline constexpr Killer kLongKillers[] = {
    VKPT_KILLER("oracle-blocks", InversePiDropped),
    VKPT_KILLER("oracle-blocks", MisWeightDropped),
    VKPT_KILLER("oracle-spheres", ConductorAbsorptionDropped),
    VKPT_KILLER("oracle-glass", FresnelOnePolarisation),
    VKPT_KILLER("oracle-glossy", MaskingDropped),
    VKPT_KILLER("oracle-glossy", CoatFresnelDropped),
    VKPT_KILLER("d2-fresnel-ends", FresnelOnePolarisation),
    VKPT_KILLER("d4-slab", FresnelOnePolarisation),
    VKPT_KILLER("d4-refraction", EtaInverted),
    VKPT_KILLER("d5-extreme-indices", RefractionScaled),
    VKPT_KILLER("d6-nested", FresnelOnePolarisation),
    VKPT_KILLER("d6-touching", RefractionScaled),
    VKPT_KILLER("d9-mirror", MirrorWeightDropped),
    VKPT_KILLER("d9-metal", ConductorAbsorptionDropped),
    VKPT_KILLER("d10-phong-head-on", PhongNormalisation),
    VKPT_KILLER("d10-phong-in-white", PhongNormalisation),
    VKPT_KILLER("d13-grazing", PhongNormalisation),
    VKPT_KILLER("d14-gain", AlbedoClamped),
    VKPT_KILLER("m1-long-paths", DepthCapped),
    VKPT_KILLER("m2-roulette-variance", SurvivalNotDivided),
    VKPT_KILLER("m3-roulette-by-channel", RouletteCapped),
    VKPT_KILLER("m4-black-walls", BlackGoesOn),
    VKPT_KILLER("m5-accumulation", PlainSums),
    VKPT_KILLER("m10-sizes-of-lights", LightAreaDropped),
    VKPT_KILLER("m11-emitting-corner", MisWeightDropped),
};

} // namespace vkpt::test
