// Rays, and where a new one may start.

CONSTANT uint kNoTriangle = 0xFFFFFFFFu;
CONSTANT Float kFarAway = 1e30; // no hit; absent boxes of the BVH lie there, and so are never entered

struct Ray {
  Vec3 o;
  Vec3 d;       // unit length
  uint exclude; // the triangle the ray starts from, never hit again; kNoTriangle for a camera ray
};

struct Hit {
  Float t;       // distance along the ray; kFarAway: nothing
  Float b1;      // barycentric coordinates of the second and third corner
  Float b2;
  uint triangle; // in BVH order
  uint id;       // in input order: ties go to the lower one, whatever the BVH
};

#ifdef VKPT_MUTATIONS
#include "naive.glsl"
#endif

// Of a component of a direction, turned aside by so much. Never infinite: 0 * infinity would be NaN for an origin in the plane.
Float inverseOf(Float x, Float aside) {
  Float size = max(abs(x) + MUTATE(BoxesMissedAside, aside, 0.0), 1e-30);
  return 1.0 / MUTATE(InfiniteInverse, x < 0.0 ? -size : size, x);
}

// How far rounding may have moved a point interpolated on a triangle, and a triangle's plane as a later ray sees
// it, along each axis: a few ulp of the corners' largest coordinate (Pharr, Jakob, Humphreys, PBRT 4th ed., 6.8.5:
// 7 ulp for the interpolation; the rest covers the translation and projection of the next intersection, which mixes
// the axes: a plane z = 0 is met at z = 0, but at a distance that x and y round).
Vec3 positionError(Vec3 v0, Vec3 v1, Vec3 v2) {
  return Vec3((16.0 * kEpsilon) * maxComponent(max(abs(v0), max(abs(v1), abs(v2)))));
}

// Moves p off its surface to the side that w points to, far enough that no rounding puts it on the other side.
// ng: unit geometric normal; error: from positionError().
Vec3 offsetRayOrigin(Vec3 p, Vec3 error, Vec3 ng, Vec3 w) {
#ifdef VKPT_MUTATIONS
  if (isNaive(kMutationAbsoluteOffset)) return offsetNaively(p, ng, w);
#endif
  Float distance = MUTATE(OffsetDropped, dot(abs(ng), error), 0.0);
  return p + ng * (MUTATE(OffsetInward, dot(ng, w) < 0.0, dot(ng, w) >= 0.0) ? -distance : distance);
}
