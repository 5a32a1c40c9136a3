// Traversal of the four-wide BVH, one ray a lane.
//
// Both sides of a branch are paid for on lavapipe, and a loop is left only at its end: so one loop, tested at the
// bottom, whose iteration takes one step in a node and one triangle of a leaf. A lane's own count of its steps
// is then also what its subgroup spends, at least for the slowest lane.

CONSTANT uint kLeafBit = 0x80000000u;
CONSTANT uint kTraversalDone = 0x7FFFFFFFu; // no node has this index
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
  Vec4 near = max(max(nearX, nearY), max(nearZ, Vec4(0.0)));
  Vec4 far = min(min(farX, farY), min(farZ, Vec4(tMax))) * (1.0 + 4.0 * kEpsilon);
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

Hit traceClosest(Ray ray) {
  Hit hit;
  hit.t = kFarAway;
  hit.b1 = 0.0;
  hit.b2 = 0.0;
  hit.triangle = kNoTriangle;
  hit.id = kNoTriangle;
  SlabRay slab = makeSlabRay(ray.d);
  RayBasis basis = makeRayBasis(ray.d);
  uint stack[kStackSize];
  stack[0] = kTraversalDone;
  int top = 1;
  uint current = 0u;
  uint steps = 0u;
  bool overflow = false;
  do {
    bool pop = false;
    if ((current & kLeafBit) == 0u) {
      UVec4 keys = intersectChildren(current, slab, ray.o, hit.t);
      UVec4 children = nodeChildren(current);
      uint a = min(keys.x, keys.y);
      uint b = max(keys.x, keys.y);
      uint c = min(keys.z, keys.w);
      uint d = max(keys.z, keys.w);
      uint first = min(a, c);
      uint e = max(a, c);
      uint last = max(b, d);
      uint f = min(b, d);
      uint second = min(e, f);
      uint third = max(e, f);
      stack[top] = childOf(children, last);
      top += last != kMiss ? 1 : 0;
      stack[top] = childOf(children, third);
      top += third != kMiss ? 1 : 0;
      stack[top] = childOf(children, second);
      top += second != kMiss ? 1 : 0;
      overflow = overflow || top > kStackSize - 4;
      top = min(top, kStackSize - 4);
      current = childOf(children, first);
      pop = first == kMiss;
    }
    if (!pop && (current & kLeafBit) != 0u) {
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
      pop = leafIsLast(current);
      current = restOfLeaf(current);
    }
    if (pop) {
      top -= 1;
      current = stack[top];
    }
    steps += 1u;
  } while (current != kTraversalDone && steps < kMaxTraversalSteps);
  reportTraversal(steps, current != kTraversalDone, overflow);
  reportClosestRay();
  return hit;
}

// Whether anything but `target` lies on the ray before tMax. Any hit will do, so children stay unsorted.
bool traceOccluded(Ray ray, Float tMax, uint target) {
  bool occluded = false;
  SlabRay slab = makeSlabRay(ray.d);
  RayBasis basis = makeRayBasis(ray.d);
  uint stack[kStackSize];
  stack[0] = kTraversalDone;
  int top = 1;
  uint current = tMax > 0.0 ? 0u : kTraversalDone;
  uint steps = 0u;
  bool overflow = false;
  do {
    bool pop = current != kTraversalDone;
    if ((current & kLeafBit) == 0u && current != kTraversalDone) {
      UVec4 keys = intersectChildren(current, slab, ray.o, tMax);
      UVec4 children = nodeChildren(current);
      stack[top] = children.x;
      top += keys.x != kMiss ? 1 : 0;
      stack[top] = children.y;
      top += keys.y != kMiss ? 1 : 0;
      stack[top] = children.z;
      top += keys.z != kMiss ? 1 : 0;
      stack[top] = children.w;
      top += keys.w != kMiss ? 1 : 0;
      overflow = overflow || top > kStackSize - 4;
      top = min(top, kStackSize - 4);
      top -= 1;
      current = stack[top];
      pop = false;
    }
    if ((current & kLeafBit) != 0u) {
      uint index = leafFirst(current);
      Float t;
      Float b1;
      Float b2;
      TriangleRecord tri = triangleRecord(index);
      bool found = intersectTriangle(ray, basis, tri.v0, tri.v1, tri.v2, t, b1, b2);
      occluded = occluded || (found && t < tMax && index != ray.exclude && index != target);
      pop = leafIsLast(current);
      current = restOfLeaf(current);
    }
    if (pop) {
      top -= 1;
      current = stack[top];
    }
    if (occluded) current = kTraversalDone;
    steps += 1u;
  } while (current != kTraversalDone && steps < kMaxTraversalSteps);
  reportTraversal(steps, current != kTraversalDone, overflow);
  reportShadowRay(tMax > 0.0);
  return occluded;
}
