// The steps of path.comp that are taken only where pixels share paths: lib/reuse.glsl.

CONSTANT uint kBegunVertices = 2u; // of a path that is begun

// A lane for every slot and sample, all at the same vertex: what is stored once for a path is stored here, since in
// tracePaths() every vertex would pay for it.
void beginPaths() {
  Work work;
  work.slot = gl_GlobalInvocationID.x;
  bool inImage = pixelOfSlot(work.slot, work.x, work.y);
  work.pixel = work.y * frame.width + work.x;
  g_slot = work.slot;
  g_pixel = work.pixel;
  g_sample = job.firstSample + gl_WorkGroupID.y;
  Path path = cameraPath(work.pixel, work.x, work.y, g_sample, randomKey());
  bool goesOn = inImage;
  if (job.fresh == 0u) {
    path = begunPath(work.slot, work.pixel, g_sample);
    goesOn = begunPathGoesOn(work.slot, g_sample);
  }
  g_firstVertex = noFirstVertex();
  g_secondVertex = noSecondVertex();
  g_ownLight = vec3(0.0);
  if (job.fresh == 0u) {
    g_firstVertex = firstVertex(work.slot, g_sample);
    g_secondVertex = secondVertex(work.slot, g_sample);
    g_ownLight = ownLight(work.slot, g_sample);
  }
  bool ends = goesOn;
  do {
    g_bounce = path.bounce;
    if (goesOn && path.bounce < kBegunVertices) goesOn = Li(path);
  } while (goesOn && path.bounce < kBegunVertices && g_steps < kStepBudget);
  ends = ends && !goesOn;
  if (ends) goesOn = startAgain(path);
  ends = ends && !goesOn;
  storeVertices(work.slot, g_sample);
  storeOwnLight(work.slot, g_sample, g_ownLight);
  storeBegunPath(path, goesOn);
  if (ends) finishSample(work, path);
  if (goesOn && path.repeat == 0u && path.bounce < kBegunVertices) atomicAdd(counters.unfinished, 1u);
  addCounters(false);
}

// A lane for every slot, sample and member of its cluster.
void connectAll() {
  g_sample = job.firstSample + gl_WorkGroupID.y;
  uint shift = clusterShift(g_sample);
  g_slot = slotByCluster(gl_GlobalInvocationID.x, shift);
  g_pixel = secondVertex(slotOfMember(g_slot, gl_WorkGroupID.z, shift), g_sample).pixel; // that a fault is found by
  g_bounce = 1u;
  connectPaths(g_slot, g_sample, gl_WorkGroupID.z);
  addShadowRays();
}

// A lane for every slot.
void addUp() {
  uint slot = gl_GlobalInvocationID.x;
  uint x;
  uint y;
  if (!pixelOfSlot(slot, x, y)) return;
  uint pixel = y * frame.width + x;
  vec3 mean = vec3(0.0);
  vec3 deviations = vec3(0.0);
  uint before = job.firstSample % kSamplesPerGroup;
  if (before != 0u) {
    mean = filmColour(kFilmOpenMean, pixel);
    deviations = filmColour(kFilmOpenDeviations, pixel);
  }
  uint count = subgroupMaximum(job.sampleCount);
  uint i = 0u;
  do {
    vec3 L = sharedValue(slot, job.firstSample + i);
    i += 1u;
    addSample(mean, deviations, float(before + i), L);
  } while (i < count);
  pathPlanes[statePlane(4u, slot)] = uvec4(floatBitsToUint(mean), 0u);
  pathPlanes[statePlane(5u, slot)] = uvec4(floatBitsToUint(deviations), 0u);
}
