#version 460
#extension GL_GOOGLE_include_directive : require
// Commits a finished batch to the film: an open group stays in float, a full one is merged in pairs of floats.

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/film.glsl"

layout(local_size_x = 64) in; // kBlockPixels

float filmFloat(uint plane, uint pixel) { return uintBitsToFloat(film[plane].values[pixel]); }

#define VKPT_MERGE_CHANNEL(channel, c)                                                                       \
  {                                                                                                          \
    Pair m = makePair(filmFloat(kFilmMean + 2u * channel, pixel), filmFloat(kFilmMean + 2u * channel + 1u, pixel)); \
    Pair d = makePair(filmFloat(kFilmDeviations + 2u * channel, pixel),                                      \
                      filmFloat(kFilmDeviations + 2u * channel + 1u, pixel));                                \
    mergeGroup(m, d, closed, mean.c, deviations.c, kSamplesPerGroup);                                        \
    film[kFilmMean + 2u * channel].values[pixel] = floatBitsToUint(m.high);                                  \
    film[kFilmMean + 2u * channel + 1u].values[pixel] = floatBitsToUint(m.low);                              \
    film[kFilmDeviations + 2u * channel].values[pixel] = floatBitsToUint(d.high);                            \
    film[kFilmDeviations + 2u * channel + 1u].values[pixel] = floatBitsToUint(d.low);                        \
  }

#define VKPT_CLOSE_KIND_CHANNEL(k, channel)                                                                  \
  {                                                                                                          \
    uint open = kindPlane(kKindOpen + channel, pixel);                                                       \
    uint high = kindPlane(kKindClosed + 2u * channel, pixel);                                                \
    uint low = kindPlane(kKindClosed + 2u * channel + 1u, pixel);                                            \
    Pair sum = addPairs(makePair(kinds[k].values[high], kinds[k].values[low]),                               \
                        makePair(kinds[k].values[open], 0.0));                                               \
    kinds[k].values[high] = sum.high;                                                                        \
    kinds[k].values[low] = sum.low;                                                                          \
    kinds[k].values[open] = 0.0;                                                                             \
  }
#define VKPT_CLOSE_KIND(k)                                                                                   \
  VKPT_CLOSE_KIND_CHANNEL(k, 0u) VKPT_CLOSE_KIND_CHANNEL(k, 1u) VKPT_CLOSE_KIND_CHANNEL(k, 2u)

// The group joins the mean of its replicate.
#define VKPT_JOIN_REPLICATE(channel, c)                                                                      \
  {                                                                                                          \
    vec4 means = uintBitsToFloat(imageLoad(replicateTexels[channel], int(pixel)));                           \
    means[replicate] += (mean.c - means[replicate]) / float(groups / kReplicates + 1u);                      \
    imageStore(replicateTexels[channel], int(pixel), floatBitsToUint(means));                                \
  }

void main() {
  uint slot = gl_GlobalInvocationID.x;
  uint x;
  uint y;
  if (!pixelOfSlot(slot, x, y)) return;
  uint pixel = y * frame.width + x;
  vec3 mean = uintBitsToFloat(pathPlanes[slot + 4u * job.slotCount].xyz);
  vec3 deviations = uintBitsToFloat(pathPlanes[slot + 5u * job.slotCount].xyz);
  uint count = film[kFilmCount].values[pixel];
  uint open = count % kSamplesPerGroup + job.sampleCount;
  film[kFilmCount].values[pixel] = count + job.sampleCount;
  if (open == kSamplesPerGroup) {
    uint closed = count + job.sampleCount - kSamplesPerGroup;
    VKPT_MERGE_CHANNEL(0u, x)
    VKPT_MERGE_CHANNEL(1u, y)
    VKPT_MERGE_CHANNEL(2u, z)
    if (kSampler == kSamplerSobol) {
      uint groups = closed / kSamplesPerGroup;
      uint replicate = groups % kReplicates;
      VKPT_JOIN_REPLICATE(0, x)
      VKPT_JOIN_REPLICATE(1, y)
      VKPT_JOIN_REPLICATE(2, z)
    }
    mean = vec3(0.0);
    deviations = vec3(0.0);
    if (kEffectKindImages) {
      VKPT_CLOSE_KIND(kKindEmission)
      VKPT_CLOSE_KIND(kKindDirect)
      VKPT_CLOSE_KIND(kKindCaustic)
      VKPT_CLOSE_KIND(kKindIndirect)
      VKPT_CLOSE_KIND(kKindIndirectCaustic)
      VKPT_CLOSE_KIND(kKindSpecular)
    }
  }
  film[kFilmOpenMean].values[pixel] = floatBitsToUint(mean.x);
  film[kFilmOpenMean + 1u].values[pixel] = floatBitsToUint(mean.y);
  film[kFilmOpenMean + 2u].values[pixel] = floatBitsToUint(mean.z);
  film[kFilmOpenDeviations].values[pixel] = floatBitsToUint(deviations.x);
  film[kFilmOpenDeviations + 1u].values[pixel] = floatBitsToUint(deviations.y);
  film[kFilmOpenDeviations + 2u].values[pixel] = floatBitsToUint(deviations.z);
}
