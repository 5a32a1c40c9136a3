// Traversal of the four-wide BVH, one ray a lane.
//
// Both sides of a branch are paid for on lavapipe, and a loop is left only at its end: so loops are tested at the
// bottom, and nodes and triangles have a loop each, since neither should be paid for while the other is worked on.
// A step is a few nodes, one leaf, one pop; the inner loops are bounded, so that counting steps bounds them all.

CONSTANT uint kLeafBit = 0x80000000u;
CONSTANT uint kTraversalDone = 0x7FFFFFFFu; // no node has this index, nor the next
CONSTANT uint kTraversalPop = 0x7FFFFFFEu;
CONSTANT uint kMiss = 0xFFFFFFFFu;

// What is constant for a ray in every node.
struct SlabRay {
  Vec3 inverse;
  uint nearX; // rows of a node's planes: the nearer one of each axis; the farther one is nearX ^ 1
  uint nearY;
  uint nearZ;
};

// A component of 0 gives a huge inverse, never infinity: 0 * infinity would be NaN for an origin in the plane.
Float safeInverse(Float x) { return 1.0 / (abs(x) < 1e-30 ? (x < 0.0 ? -1e-30 : 1e-30) : x); }

SlabRay makeSlabRay(Vec3 d) {
  SlabRay s;
  s.inverse = Vec3(safeInverse(d.x), safeInverse(d.y), safeInverse(d.z));
  s.nearX = s.inverse.x < 0.0 ? 1u : 0u;
  s.nearY = s.inverse.y < 0.0 ? 3u : 2u;
  s.nearZ = s.inverse.z < 0.0 ? 5u : 4u;
  return s;
}

// Sort keys of the four children: the distance with the child's slot in the low bits, or kMiss. Conservative:
// the far distance is stretched by twice the rounding of its three operations (Ize 2013, "Robust BVH Ray
// Traversal", JCGT 2(2)).
UVec4 intersectChildren(uint node, SlabRay slab, Vec3 o, Float tMax) {
  Vec4 nearX = (nodeBounds(node, slab.nearX) - o.x) * slab.inverse.x;
  Vec4 nearY = (nodeBounds(node, slab.nearY) - o.y) * slab.inverse.y;
  Vec4 nearZ = (nodeBounds(node, slab.nearZ) - o.z) * slab.inverse.z;
  Vec4 farX = (nodeBounds(node, slab.nearX ^ 1u) - o.x) * slab.inverse.x;
  Vec4 farY = (nodeBounds(node, slab.nearY ^ 1u) - o.y) * slab.inverse.y;
  Vec4 farZ = (nodeBounds(node, slab.nearZ ^ 1u) - o.z) * slab.inverse.z;
  Vec4 near = slabMax(slabMax(nearX, nearY), slabMax(nearZ, Vec4(0.0)));
  Vec4 far = slabMin(slabMin(farX, farY), slabMin(farZ, Vec4(tMax))) * (1.0 + 4.0 * kEpsilon);
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

// The child that is next by the top of the stack; kTraversalDone when there is none.
uint popChild(INOUT(TraversalStack) stack) {
  uint entry = topOfStack(stack);
  uint count = (entry >> 6u) & 3u;
  bool empty = entry == kEmptyStack;
  uint child = childOf(nodeChildren(empty ? 0u : entry >> 8u), entry);
  if (count == 1u) {
    popStack(stack);
  } else if (!empty) {
    replaceTop(stack, (entry & 0xFFFFFF00u) | ((count - 1u) << 6u) | ((entry & 63u) >> 2u));
  }
  return empty ? kTraversalDone : child;
}

// Intersects a node's children, nearest first: returns the first of those that are hit and leaves the others on
// the stack; kTraversalPop when there is none.
uint visitNode(uint node, SlabRay slab, Vec3 o, Float tMax, INOUT(TraversalStack) stack) {
  UVec4 keys = intersectChildren(node, slab, o, tMax);
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
  if (rest != 0u) {
    pushStack(stack, (node << 8u) | rest | (second & 3u) | ((third & 3u) << 2u) | ((fourth & 3u) << 4u));
  }
  return first == kMiss ? kTraversalPop : childOf(nodeChildren(node), first);
}

Hit traceClosest(Ray ray) {
  Hit hit;
  hit.t = kFarAway;
  hit.b1 = 0.0;
  hit.b2 = 0.0;
  hit.triangle = kNoTriangle;
  hit.id = kNoTriangle;
  SlabRay slab = makeSlabRay(ray.d);
  RayBasis basis = makeRayBasis(ray.d);
  TraversalStack stack = emptyStack();
  uint current = 0u;
  uint steps = 0u;
  do {
    uint nodes = 0u;
    do {
      if (current < kTraversalPop) current = visitNode(current, slab, ray.o, hit.t, stack);
      nodes += 1u;
    } while (current < kTraversalPop && nodes < kNodesPerStep);
    bool more = (current & kLeafBit) != 0u;
    do {
      if (more) {
        uint index = leafFirst(current);
        Float t;
        Float b1;
        Float b2;
        TriangleRecord tri = triangleRecord(index);
        bool found = intersectTriangle(ray, basis, tri.v0, tri.v1, tri.v2, t, b1, b2);
        if (found && index != ray.exclude && (t < hit.t || (t == hit.t && tri.id < hit.id))) {
          hit.t = t;
          hit.b1 = b1;
          hit.b2 = b2;
          hit.triangle = index;
          hit.id = tri.id;
        }
        more = !leafIsLast(current);
        current = more ? restOfLeaf(current) : kTraversalPop;
      }
    } while (more);
    if (current == kTraversalPop) current = popChild(stack);
    steps += 1u;
  } while (current != kTraversalDone && steps < kMaxTraversalSteps);
  reportTraversal(steps, current != kTraversalDone);
  reportClosestRay();
  return hit;
}

// Steps that one shadow ray may take: several at a vertex share them.
uint shadowSteps() { return kEffectLightSamples ? kMaxTraversalSteps / lightSamples() : kMaxTraversalSteps; }

// Whether anything but `target` lies on the ray before tMax.
bool traceOccluded(Ray ray, Float tMax, uint target) {
  bool occluded = false;
  SlabRay slab = makeSlabRay(ray.d);
  RayBasis basis = makeRayBasis(ray.d);
  TraversalStack stack = emptyStack();
  uint current = tMax > 0.0 ? 0u : kTraversalDone;
  uint most = shadowSteps(); // once: drivers leave a division in the loop
  uint steps = 0u;
  do {
    uint nodes = 0u;
    do {
      if (current < kTraversalPop) current = visitNode(current, slab, ray.o, tMax, stack);
      nodes += 1u;
    } while (current < kTraversalPop && nodes < kNodesPerStep);
    bool more = (current & kLeafBit) != 0u;
    do {
      if (more) {
        uint index = leafFirst(current);
        Float t;
        Float b1;
        Float b2;
        TriangleRecord tri = triangleRecord(index);
        bool found = intersectTriangle(ray, basis, tri.v0, tri.v1, tri.v2, t, b1, b2);
        occluded = occluded || (found && t < tMax && index != ray.exclude && index != target);
        more = !leafIsLast(current) && !occluded;
        current = more ? restOfLeaf(current) : kTraversalPop;
      }
    } while (more);
    if (current == kTraversalPop) current = popChild(stack);
    if (occluded) current = kTraversalDone;
    steps += 1u;
  } while (current != kTraversalDone && steps < most);
  reportTraversal(steps, current != kTraversalDone);
  reportShadowRay(tMax > 0.0);
  return occluded;
}
