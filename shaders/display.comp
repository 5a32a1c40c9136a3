#version 460
#extension GL_GOOGLE_include_directive : require
// The film as a picture: exposure and tonemap. A pixel that has no sample yet keeps what was shown there before.

#include "shared/language.h"
#include "shared/structs.h"
#include "lib/display.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = kDisplayFilm, std430) readonly buffer FilmBlock { uint values[]; } film[kFilmPlanes];
layout(set = 0, binding = kDisplayPixels, std430) buffer PixelBlock { uint pixels[]; };
layout(set = 0, binding = kDisplaySplats, r32ui) uniform readonly uimageBuffer splatTexels;
layout(push_constant) uniform JobBlock { DisplayJob job; };

float filmFloat(uint plane, uint pixel) { return uintBitsToFloat(film[plane].values[pixel]); }

// Of both the closed groups of samples and the open one, for channel 0, 1 or 2.
#define VKPT_MEAN(c) mix(filmFloat(kFilmMean + 2u * c, pixel), filmFloat(kFilmOpenMean + c, pixel), share)
#define VKPT_DEVIATIONS(c)                                                                                   \
  joined(filmFloat(kFilmMean + 2u * c, pixel), filmFloat(kFilmOpenMean + c, pixel),                          \
         filmFloat(kFilmDeviations + 2u * c, pixel), filmFloat(kFilmOpenDeviations + c, pixel), closed, open)

// Sum of squared deviations of two sets: Chan, as in lib/film.glsl, in the precision that a picture needs.
float joined(float meanA, float meanB, float a, float b, float nA, float nB) {
  float delta = meanB - meanA;
  return a + b + delta * delta * nA * nB / (nA + nB);
}

// A sum of splats.
float splatSum(uint number) {
  return float(imageLoad(splatTexels, int(number)).x) + 4294967296.0 * float(imageLoad(splatTexels, int(number + 1u)).x);
}

void main() {
  uint at = gl_GlobalInvocationID.x;
  if (at >= job.width * job.height) return;
  uint x = (at % job.width) * job.filmWidth / job.width;
  uint y = (at / job.width) * job.filmHeight / job.height;
  uint pixel = y * job.filmWidth + x;
  uint count = film[kFilmCount].values[pixel];
  if (count == 0u) return;
  float n = float(count);
  float open = float(count % kSamplesPerGroup);
  float closed = n - open;
  float share = open / n;
  vec3 shown = vec3(VKPT_MEAN(0u), VKPT_MEAN(1u), VKPT_MEAN(2u));
  uint splats = pixel * kSplatNumbers;
  if (job.splatUnit > 0.0) {
    shown += vec3(splatSum(splats), splatSum(splats + 4u), splatSum(splats + 8u)) * job.splatUnit;
  }
  if (job.shows == kShowsStandardError) {
    vec3 deviations = vec3(VKPT_DEVIATIONS(0u), VKPT_DEVIATIONS(1u), VKPT_DEVIATIONS(2u));
    vec3 variance = deviations / (n * (n - 1.0));
    if (job.splatUnit > 0.0) {
      variance += vec3(splatSum(splats + 2u), splatSum(splats + 6u), splatSum(splats + 10u)) * job.splatSquareUnit;
    }
    shown = count < 2u ? vec3(0.0) : sqrt(variance);
  }
  uint r = displayByte(shown.x, job.scale, job.tonemap);
  uint g = displayByte(shown.y, job.scale, job.tonemap);
  uint b = displayByte(shown.z, job.scale, job.tonemap);
  pixels[at] = 0xFF000000u | (g << 8u) | (job.redLast != 0u ? (r << 16u) | b : (b << 16u) | r);
}
