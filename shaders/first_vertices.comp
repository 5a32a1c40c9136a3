#version 460
#extension GL_GOOGLE_include_directive : require
// Where pixels share paths: the first two vertices of all paths of a batch, a lane for every slot and sample. All lanes
// are at the same vertex; what is stored once for a path is stored here, since in path.comp every vertex would pay for it.
// What is the same for all lanes comes by way of the subgroup where it decides a branch: else lavapipe compiles the
// kernel anew for each of its values.

#define VKPT_LEAVES_VERTICES
#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"
#include "begun_paths.glsl"

layout(local_size_x = 64) in; // kBlockPixels

CONSTANT uint kBegunVertices = 2u; // of a path that is begun

void main() {
  uint x;
  uint y;
  g_slot = gl_GlobalInvocationID.x;
  bool inImage = pixelOfSlot(g_slot, x, y);
  g_pixel = y * frame.width + x;
  g_sample = job.firstSample + gl_WorkGroupID.y;
  Path path = cameraPath(g_pixel, x, y, g_sample, randomKey());
  bool goesOn = inImage;
  bool fresh = subgroupMaximum(job.fresh) != 0u;
  if (!fresh) {
    path = begunPath(g_slot, g_pixel, g_sample);
    goesOn = begunPathGoesOn(g_slot, g_sample);
  }
  g_firstVertex = noFirstVertex();
  g_secondVertex = noSecondVertex();
  g_ownLight = vec3(0.0);
  if (!fresh) {
    g_firstVertex = firstVertex(g_slot, g_sample);
    g_secondVertex = secondVertex(g_slot, g_sample);
    g_ownLight = ownLight(g_slot, g_sample);
  }
  bool ends = goesOn;
  do {
    g_bounce = path.bounce;
    if (goesOn && path.bounce < kBegunVertices) goesOn = Li(path);
  } while (goesOn && path.bounce < kBegunVertices && g_steps < kStepBudget);
  ends = ends && !goesOn;
  if (ends) goesOn = startAgain(path);
  ends = ends && !goesOn;
  storeVertices(g_slot, g_sample);
  storeOwnLight(g_slot, g_sample, g_ownLight);
  storeBegunPath(path, goesOn);
  if (ends) storePathsLight(path, countedLight(path.L));
  if (goesOn && path.repeat == 0u && path.bounce < kBegunVertices) atomicAdd(counters.unfinished, 1u);
  addCounters(false);
}
