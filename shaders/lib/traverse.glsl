// Traversal of the four-wide BVH, one ray a lane.
//
// Both sides of a branch are paid for on lavapipe, and a loop is left only at its end: so loops are tested at the
// bottom, and nodes and triangles have a loop each, since neither should be paid for while the other is worked on.
// A step is a few nodes, one leaf, one pop; the inner loops are bounded, so that counting steps bounds them all.

CONSTANT uint kLeafBit = 0x80000000u;
CONSTANT uint kTraversalDone = 0x7FFFFFFFu; // no node has this index, nor the next
CONSTANT uint kTraversalPop = 0x7FFFFFFEu;
CONSTANT uint kMiss = 0xFFFFFFFFu;

// In a deep tree a node without a hit makes way for the next one on the stack at once, not after the leaves' turn, and a
// step has more nodes: by measurement the Cornell spheres become 1.1 times as fast, meshes 1.2 times. Where nearly every
// node leads to a leaf, as in the Cornell box, both cost more than they save.
CONSTANT bool kDeepTree = kStackDepth > 6u;
CONSTANT uint kNodesInStep = kDeepTree ? kNodesPerStep : 2u;

// What is constant for a ray in every node.
struct SlabRay {
  Vec3 nearInverse;
  Vec3 farInverse;
  uint nearX; // rows of a node's planes: the nearer one of each axis; the farther one is nearX ^ 1
  uint nearY;
  uint nearZ;
};

// The triangle test sees a ray through a basis that rounding turns a little: by so much of the way a hit may lie aside
// of where d leads, and no box may be missed for it. (Rounding of the basis, 4 ulp in each of two vectors, and of the
// projection, 4 ulp of the way.) A third more makes up for the three roundings of a slab's distance (Ize 2013, "Robust
// BVH Ray Traversal", JCGT 2(2)): no component is above 1, so the inverses put both ends off by at least as much.
CONSTANT Float kAside = 12.0 * kEpsilon;

SlabRay makeSlabRay(Vec3 d) {
  SlabRay s;
  s.nearInverse = Vec3(inverseOf(d.x, kAside), inverseOf(d.y, kAside), inverseOf(d.z, kAside));
  s.farInverse = Vec3(inverseOf(d.x, -kAside), inverseOf(d.y, -kAside), inverseOf(d.z, -kAside));
  s.nearX = d.x < 0.0 ? 1u : 0u;
  s.nearY = d.y < 0.0 ? 3u : 2u;
  s.nearZ = d.z < 0.0 ? 5u : 4u;
  return s;
}

// Sort keys of the four children: the distance with the child's slot in the low bits, or kMiss. Conservative by the
// ray's inverses.
UVec4 intersectChildren(uint node, SlabRay slab, Vec3 o, Float tMax) {
  Vec4 nearX = (nodeBounds(node, slab.nearX) - o.x) * slab.nearInverse.x;
  Vec4 nearY = (nodeBounds(node, slab.nearY) - o.y) * slab.nearInverse.y;
  Vec4 nearZ = (nodeBounds(node, slab.nearZ) - o.z) * slab.nearInverse.z;
  Vec4 farX = (nodeBounds(node, slab.nearX ^ 1u) - o.x) * slab.farInverse.x;
  Vec4 farY = (nodeBounds(node, slab.nearY ^ 1u) - o.y) * slab.farInverse.y;
  Vec4 farZ = (nodeBounds(node, slab.nearZ ^ 1u) - o.z) * slab.farInverse.z;
  Vec4 near = slabMax(slabMax(nearX, nearY), slabMax(nearZ, Vec4(0.0)));
  Vec4 far = slabMin(slabMin(farX, farY), slabMin(farZ, Vec4(tMax)));
  UVec4 keys;
  keys.x = near.x <= far.x ? (orderKey(near.x) & ~3u) : kMiss;
  keys.y = near.y <= far.y ? ((orderKey(near.y) & ~3u) | 1u) : kMiss;
  keys.z = near.z <= far.z ? ((orderKey(near.z) & ~3u) | 2u) : kMiss;
  keys.w = near.w <= far.w ? ((orderKey(near.w) & ~3u) | 3u) : kMiss;
  return keys;
}

uint childOf(UVec4 children, uint key) {
  uint low = (key & 1u) == 0u ? children.x : children.y;
  uint high = (key & 1u) == 0u ? children.z : children.w;
  return (key & 2u) == 0u ? low : high;
}

// A leaf is walked by turning its reference into that of the leaf without its first triangle.
uint restOfLeaf(uint leaf) { return leaf - (1u << 28u) + 1u; }
uint leafFirst(uint leaf) { return leaf & 0x0FFFFFFFu; }
bool leafIsLast(uint leaf) { return (leaf & 0x70000000u) == 0u; }

// A stack entry is a node and those of its children that are still to be visited, in order: the node's index from
// bit 8 on, the slots in pairs of bits from bit 0 on, their number in bits 6 and 7.

// Takes the next child off the top of the stack.
void dropChild(INOUT(TraversalStack) stack, bool drop) {
  uint entry = topOfStack(stack);
  uint count = (entry >> 6u) & 3u;
  replaceTop(stack, drop ? (entry & 0xFFFFFF00u) | ((count - 1u) << 6u) | ((entry & 63u) >> 2u) : entry);
  popStack(stack, drop && count == 1u);
}

// A ray on its way through the BVH: one that looks for the closest hit, or for any.
struct Traversal {
  Ray ray;
  SlabRay slab;
  RayBasis basis;
  TraversalStack stack;
  uint current; // a child's reference, kTraversalPop or kTraversalDone
  uint steps;   // taken so far
  bool anyHit;
  uint target;  // of a ray that looks for any hit: a triangle that is none
  Hit hit;      // the closest so far
};

// Of a traversal that has ended what has no meaning keeps its value: the stack below its end, the coordinates of no hit.
void beginAgain(INOUT(Traversal) t, Ray ray, Float tMax) {
  t.ray = ray;
  t.slab = makeSlabRay(ray.d);
  t.basis = makeRayBasis(ray.d);
  clearStack(t.stack);
  t.current = tMax > 0.0 ? 0u : kTraversalDone;
  t.steps = 0u;
  t.anyHit = false;
  t.target = kNoTriangle;
  t.hit.t = tMax;
  t.hit.triangle = kNoTriangle;
  t.hit.id = kNoTriangle;
}
Traversal beginTraversal(Ray ray, Float tMax) {
  Traversal t;
  t.stack = emptyStack();
  t.hit.b1 = 0.0;
  t.hit.b2 = 0.0;
  beginAgain(t, ray, tMax);
  return t;
}
Traversal beginClosest(Ray ray) { return beginTraversal(ray, kFarAway); }
// Makes a new one look for anything but `target` before its tMax.
void lookForAny(INOUT(Traversal) t, uint target) {
  t.anyHit = true;
  t.target = target;
  t.hit.id = 0u; // at tMax itself is no hit
}

// Visits and pops are selects, not branches, which cost as much and a blend of the whole stack besides.

// Intersects a node's children, nearest first: goes on with the first of those that are hit and leaves the others on
// the stack.
void visitNode(INOUT(Traversal) t) {
  bool here = t.current < kTraversalPop;
  uint node = here ? t.current : 0u;
  UVec4 keys = intersectChildren(node, t.slab, t.ray.o, t.hit.t);
  uint a = min(keys.x, keys.y);
  uint b = max(keys.x, keys.y);
  uint c = min(keys.z, keys.w);
  uint d = max(keys.z, keys.w);
  uint first = min(a, c);
  uint e = max(a, c);
  uint f = min(b, d);
  uint fourth = max(b, d);
  uint second = min(e, f);
  uint third = max(e, f);
  uint rest = (second != kMiss ? 64u : 0u) + (third != kMiss ? 64u : 0u) + (fourth != kMiss ? 64u : 0u);
  pushStack(t.stack, here && rest != 0u,
            (node << 8u) | rest | (second & 3u) | ((third & 3u) << 2u) | ((fourth & 3u) << 4u));
  uint top = topOfStack(t.stack);
  bool misses = first == kMiss;
  bool pops = kDeepTree && here && misses && top != kEmptyStack;
  uint child = childOf(nodeChildren(pops ? top >> 8u : node), pops ? top : first);
  uint other = kDeepTree ? kTraversalDone : kTraversalPop;
  uint next = misses && !pops ? other : child;
  if (kDeepTree) dropChild(t.stack, pops);
  t.current = here ? next : t.current;
}

// Goes on by the top of the stack.
void popChild(INOUT(Traversal) t) {
  bool here = t.current == kTraversalPop;
  uint top = topOfStack(t.stack);
  bool pops = here && top != kEmptyStack;
  uint child = childOf(nodeChildren(pops ? top >> 8u : 0u), top);
  uint next = pops ? child : kTraversalDone;
  dropChild(t.stack, pops);
  t.current = here ? next : t.current;
}

// One step: a few nodes, one leaf, one pop.
void stepTraversal(INOUT(Traversal) t) {
  uint nodes = 0u;
  do {
    visitNode(t);
    nodes += 1u;
  } while (t.current < kTraversalPop && nodes < kNodesInStep);
  bool more = (t.current & kLeafBit) != 0u;
  do {
    if (more) {
      uint index = leafFirst(t.current);
      Float distance;
      Float b1;
      Float b2;
      TriangleRecord tri = triangleRecord(index);
      bool found = intersectTriangle(t.ray, t.basis, tri.v0, tri.v1, tri.v2, distance, b1, b2);
      bool wins = MUTATE(TiesAtRandom, tri.id < t.hit.id, tri.id > t.hit.id);
      bool nearer = distance < t.hit.t || (distance == t.hit.t && wins);
      if (found && nearer && index != t.ray.exclude && index != t.target) {
        t.hit.t = distance;
        t.hit.b1 = b1;
        t.hit.b2 = b2;
        t.hit.triangle = index;
        t.hit.id = tri.id;
      }
      more = !leafIsLast(t.current);
      t.current = more ? restOfLeaf(t.current) : kTraversalPop;
    }
  } while (more);
  popChild(t);
  if (t.anyHit && t.hit.triangle != kNoTriangle) t.current = kTraversalDone;
  t.steps += 1u;
}

bool traversalEnded(Traversal t, uint limit) { return t.current == kTraversalDone || t.steps >= limit; }
bool traversalCut(Traversal t) { return t.current != kTraversalDone; } // of one that has ended

Hit traceClosest(Ray ray) {
  Traversal t = beginClosest(ray);
  do {
    stepTraversal(t);
  } while (!traversalEnded(t, kMaxTraversalSteps));
  reportTraversal(t.steps, traversalCut(t));
  reportClosestRay();
  return t.hit;
}

// Steps that one shadow ray may take: several at a vertex share them.
uint shadowSteps() { return kEffectLightSamples ? kMaxTraversalSteps / lightSamples() : kMaxTraversalSteps; }

// Whether anything but `target` lies on the ray before tMax.
bool traceOccluded(Ray ray, Float tMax, uint target) {
  Traversal t = beginTraversal(ray, tMax);
  lookForAny(t, target);
  uint most = shadowSteps(); // once: drivers leave a division in the loop
  do {
    stepTraversal(t);
  } while (!traversalEnded(t, most));
  reportTraversal(t.steps, traversalCut(t));
  reportShadowRay(tMax > 0.0);
  return t.hit.triangle != kNoTriangle;
}
