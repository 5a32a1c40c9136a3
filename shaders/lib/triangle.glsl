// Watertight ray-triangle intersection.
//
// Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1), with two changes. The corners are
// projected along the ray by a basis perpendicular to it, not by a shear with swapped axes. And there is no
// double-precision fallback: rounding is monotonic, so a product difference x0 y1 - x1 y0 never gets the wrong
// sign, it may only be 0 by mistake; with edges that are exactly antisymmetric (`precise`: no contraction),
// inclusive tests and ties broken by the lowest id no ray slips through a shared edge or vertex.

struct RayBasis {
  Vec3 s;
  Vec3 t;
};

RayBasis makeRayBasis(Vec3 d) {
  Frame f = makeFrame(d);
  RayBasis b;
  b.s = f.s;
  b.t = f.t;
  return b;
}

// Corner v as the ray sees it: x, y across, z along.
Vec3 projectCorner(Ray ray, RayBasis basis, Vec3 v) {
  precise Vec3 p = v - ray.o;
  precise Float x = p.x * basis.s.x + p.y * basis.s.y + p.z * basis.s.z;
  precise Float y = p.x * basis.t.x + p.y * basis.t.y + p.z * basis.t.z;
  precise Float z = p.x * ray.d.x + p.y * ray.d.y + p.z * ray.d.z;
  return Vec3(x, y, z);
}

// Twice the signed area of (0, a, b); edgeFunction(b, a) is exactly -edgeFunction(a, b).
Float edgeFunction(Vec3 a, Vec3 b) {
  precise Float ab = a.x * b.y;
  precise Float ba = a.y * b.x;
  precise Float e = ab - ba;
  return e;
}

// Hits with 0 < t < tMax. Returns whether there is one; then t, b1, b2 are set.
bool intersectTriangle(Ray ray, RayBasis basis, Vec3 v0, Vec3 v1, Vec3 v2, OUT(Float) t, OUT(Float) b1,
                       OUT(Float) b2) {
#ifdef VKPT_MUTATIONS
  if (isNaive(kMutationLeakyTriangle)) return intersectNaively(ray, v0, v1, v2, t, b1, b2);
#endif
  Vec3 p0 = projectCorner(ray, basis, v0);
  Vec3 p1 = projectCorner(ray, basis, v1);
  Vec3 p2 = projectCorner(ray, basis, v2);
  Float e0 = edgeFunction(p1, p2);
  Float e1 = edgeFunction(p2, p0);
  Float e2 = edgeFunction(p0, p1);
  Float det = e0 + e1 + e2;
  Float scale = 1.0 / det;
  b1 = e1 * scale;
  b2 = e2 * scale;
  t = (e0 * p0.z + e1 * p1.z + e2 * p2.z) * scale;
  Float low = min(e0, min(e1, e2));
  Float high = max(e0, max(e1, e2));
  return (low >= 0.0 || high <= 0.0) && det != 0.0 && t > 0.0;
}
