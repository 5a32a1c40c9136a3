// What a ray meets.

// 32 roundings of a float, in every program: they are to trace the same paths.
CONSTANT Float kInward = 3.814697265625e-6;

// Where a triangle is hit, but not so close to an edge that rounding may put the point behind the neighbour there: from
// there a ray would leave the scene.
Vec3 pointWithin(TriangleRecord tri, Hit hit) {
  Float inward = MUTATE(HitsUpToTheEdge, kInward, 0.0);
  Float b1 = hit.b1 + (1.0 / 3.0 - hit.b1) * inward;
  Float b2 = hit.b2 + (1.0 / 3.0 - hit.b2) * inward;
  return tri.v0 * (1.0 - b1 - b2) + tri.v1 * b1 + tri.v2 * b2;
}

Surface surfaceAt(Hit hit, Vec3 wo) {
  Surface s;
  TriangleRecord tri = triangleRecord(hit.triangle);
  Float b0 = 1.0 - hit.b1 - hit.b2;
  s.p = pointWithin(tri, hit);
  s.error = positionError(tri.v0, tri.v1, tri.v2);
  Vec3 across = cross(tri.v1 - tri.v0, tri.v2 - tri.v0);
  s.ng = normalize(across);
  s.doubleArea = length(across);
  s.lightLeaf = tri.lightLeaf;
  s.front = dot(s.ng, wo) > 0.0;
  s.ng = s.front ? s.ng : -s.ng;
  s.n = s.ng;
  s.ns = s.ng;
  if (kEffectSmoothNormals) {
    Vec3 n = triangleNormal(hit.triangle, 0u) * b0 + triangleNormal(hit.triangle, 1u) * hit.b1 +
             triangleNormal(hit.triangle, 2u) * hit.b2;
    n = dot(n, s.ng) < 0.0 ? -n : n;
    s.ns = n;
    // A shading normal that the viewer can't see can't shade: the geometric one stands in.
    if (dot(n, wo) > 0.0) s.n = normalize(n);
  }
  s.m = material(tri.material);
  if (kEffectTextures && s.m.texture != kNoTexture) {
    Vec2 uv = triangleUv(hit.triangle, 0u) * b0 + triangleUv(hit.triangle, 1u) * hit.b1 +
              triangleUv(hit.triangle, 2u) * hit.b2;
    s.m.reflectance = s.m.reflectance * textureAt(s.m.texture, uv);
  }
  return s;
}

// As it is seen along w.
Surface seenFrom(Surface s, Vec3 w) {
  Surface e = s;
  bool behind = dot(s.ng, w) < 0.0;
  if (behind) {
    e.ng = -s.ng;
    e.ns = -s.ns;
    e.front = !s.front;
  }
  e.n = e.ng;
  if (kEffectSmoothNormals && dot(e.ns, w) > 0.0) e.n = normalize(e.ns);
  return e;
}

bool scattersHere(Surface s) { return s.front || (s.m.flags & kMaterialOneSided) == 0u; }
