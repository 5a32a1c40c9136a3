// Paths that neighbouring pixels share: Bekaert, Sbert, Halton 2002, "Accelerating Path Tracing by Re-Using Paths".
//
// A path is cut between its first two vertices, E x1 | x2 ... L. What x2 sends on is the same for every eye: x1 of
// each pixel of a cluster is connected with x2 of each, and all of them together are one estimator of what arrives at
// x1, every x2 weighted by the balance heuristic with the densities that all pixels of the cluster have there. Both vertices
// are diffuse and x1 is the eye's first; any other path counts for its own pixel alone. Rays between vertices that
// one path has joined are not traced again.

// Of Path.reuse: how far a path is.
CONSTANT uint kReuseNone = 0u;   // no vertex yet
CONSTANT uint kReuseFirst = 1u;  // at x1
CONSTANT uint kReuseAlone = 2u;  // beyond a first vertex that has no x2
CONSTANT uint kReuseShared = 3u; // beyond x2

FirstVertex noFirstVertex() {
  FirstVertex a;
  a.o = Vec3(0.0);
  a.n = Vec3(0.0);
  a.ng = Vec3(0.0);
  a.weight = Vec3(0.0);
  return a;
}
SecondVertex noSecondVertex() {
  SecondVertex b;
  b.end = Vec3(0.0);
  b.triangle = kNoTriangle;
  b.ng = Vec3(0.0);
  b.pixel = 0u;
  return b;
}

bool reusesPaths() { return kEffectPathReuse && kReuseEdge > 1u; }

bool reusable(Surface s) {
  return kEffectDiffuse && s.m.bsdf == kBsdfDiffuse && maxComponent(s.m.reflectance) > 0.0;
}
// x2 is seen from other places than its own path's, where a shading normal may be out of sight.
bool reusableFrom(Surface s) { return reusable(s) && dot(s.ns, s.ng) >= 0.999999 * length(s.ns); }

// x1, from which the path goes on with a probability of `survival`.
void leaveFirstVertex(INOUT(Path) path, Surface s, Float survival) {
  FirstVertex a;
  a.o = offsetRayOrigin(s.p, s.error, s.ng, s.ng);
  a.n = s.n * survival;
  a.ng = s.ng;
  a.weight = s.m.reflectance * (path.sampleWeight / survival);
  keepFirstVertex(a);
  path.reuse = kReuseFirst;
}

// x2: from here on the path gathers what x2 sends on.
void leaveSecondVertex(INOUT(Path) path, Surface s, uint triangle) {
  SecondVertex b;
  b.end = offsetRayOrigin(s.p, s.error, s.ng, s.ng);
  b.triangle = triangle;
  b.ng = s.ng;
  b.pixel = path.pixel;
  keepSecondVertex(b, path.L * path.sampleWeight);
  path.L = Vec3(0.0);
  path.beta = Vec3(1.0);
  path.reuse = kReuseShared;
}

// Density over area with which BSDF sampling at x1 finds x2, if nothing is in between.
Float connectionPdf_A(FirstVertex a, SecondVertex b) {
  Vec3 span = b.end - a.o;
  Float r2 = dot(span, span);
  Vec3 w = span / sqrt(r2);
  Float cosFirst = dot(a.n, w);
  Float cosSecond = -dot(b.ng, w);
  bool faces = r2 > 0.0 && cosFirst > 0.0 && cosSecond > 0.0 && (!kEffectSmoothNormals || dot(a.ng, w) > 0.0);
  return faces ? cosFirst * kInvPi * MUTATE(ReuseGeometryDropped, cosSecond, 1.0) / r2 : 0.0;
}

// --- clusters: squares of kReuseEdge pixels, side by side in a block whose edges are joined. They move from sample to sample,
// so that no square shows in the image. A slot is a block's pixel: kBlockPixels slots a block, in Morton order.

uint clusterShift(uint sampleLow) { return pcg4d(UVec4(sampleLow, 0u, 0u, 0u)).x; }

// Number of a slot within its cluster.
uint memberOfSlot(uint slot, uint shift) {
  uint column = columnInBlock(slot % kBlockPixels) + shift;
  uint row = rowInBlock(slot % kBlockPixels) + (shift >> 3u);
  return (row % kReuseEdge) * kReuseEdge + column % kReuseEdge;
}
// Slots in an order that has each cluster's side by side.
uint slotByCluster(uint i, uint shift) {
  uint column = columnInBlock(i % kBlockPixels) - shift;
  uint row = rowInBlock(i % kBlockPixels) - (shift >> 3u);
  return i - i % kBlockPixels + placeInBlock(column % kBlockEdge, row % kBlockEdge);
}
// The slot of a member of another slot's cluster.
uint slotOfMember(uint slot, uint member, uint shift) {
  uint column = columnInBlock(slot % kBlockPixels) + shift;
  uint row = rowInBlock(slot % kBlockPixels) + (shift >> 3u);
  column = column - column % kReuseEdge + member % kReuseEdge - shift;
  row = row - row % kReuseEdge + member / kReuseEdge - (shift >> 3u);
  return slot - slot % kBlockPixels + placeInBlock(column % kBlockEdge, row % kBlockEdge);
}

// --- three steps for every sample, each for all slots of a block before the next

// 1. Density with which the slot's x1 finds the x2 of a member of its cluster: negative where something is in between.
void connectPaths(uint slot, uint sampleLow, uint member) {
  uint other = slotOfMember(slot, member, clusterShift(sampleLow));
  FirstVertex a = firstVertex(slot, sampleLow);
  SecondVertex b = secondVertex(other, sampleLow);
  Float pdf_A = connectionPdf_A(a, b);
  Vec3 span = b.end - a.o;
  Float distance = length(span);
  Ray ray;
  ray.o = a.o;
  ray.d = span / distance;
  ray.exclude = kNoTriangle;
  bool asks = pdf_A > 0.0 && slot != other && MUTATE(ReuseThroughWalls, true, false);
  bool occluded = traceOccluded(ray, asks ? distance : 0.0, b.triangle);
  storeConnection(slot, sampleLow, member, occluded ? -pdf_A : pdf_A);
}

// 2. The density that all of the cluster together have at the slot's x2.
void balancePaths(uint slot, uint sampleLow) {
  uint shift = clusterShift(sampleLow);
  uint own = memberOfSlot(slot, shift);
  Float sum = 0.0;
  uint k = 0u;
  do {
    Float pdf_A = connection(slotOfMember(slot, k, shift), sampleLow, own);
    sum += MUTATE(ReuseBlockedCounts, max(pdf_A, 0.0), abs(pdf_A));
    k += 1u;
  } while (k < kReuseEdge * kReuseEdge);
  storeBalance(slot, sampleLow, sum);
}

// 3. A sample's value.
Vec3 sharedValue(uint slot, uint sampleLow) {
  uint shift = clusterShift(sampleLow);
  Vec3 sum = Vec3(0.0);
  uint k = 0u;
  do {
    Float pdf_A = connection(slot, sampleLow, k);
    SharedLight light = sharedLight(slotOfMember(slot, k, shift), sampleLow);
    if (pdf_A > 0.0) sum += light.L * (pdf_A / light.pdf_A);
    k += 1u;
  } while (k < kReuseEdge * kReuseEdge);
  Vec3 value = ownLight(slot, sampleLow);
  if (maxComponent(sum) > 0.0) value += firstVertex(slot, sampleLow).weight * sum;
  return value;
}

// Of a path for its own pixel alone.
Vec3 unsharedValue(Path path, Vec3 L, uint slot) {
  if (path.reuse != kReuseShared) return L * path.sampleWeight;
  return ownLight(slot, path.sampleLow) + firstVertex(slot, path.sampleLow).weight * L;
}
