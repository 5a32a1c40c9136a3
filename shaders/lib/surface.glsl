// What a ray meets.

Surface surfaceAt(Hit hit, Vec3 wo) {
  Surface s;
  TriangleRecord tri = triangleRecord(hit.triangle);
  Float b0 = 1.0 - hit.b1 - hit.b2;
  s.p = tri.v0 * b0 + tri.v1 * hit.b1 + tri.v2 * hit.b2;
  s.error = positionError(tri.v0, tri.v1, tri.v2);
  s.ng = normalize(cross(tri.v1 - tri.v0, tri.v2 - tri.v0));
  s.front = dot(s.ng, wo) > 0.0;
  s.ng = s.front ? s.ng : -s.ng;
  s.n = s.ng;
  if (kEffectSmoothNormals) {
    Vec3 n = triangleNormal(hit.triangle, 0u) * b0 + triangleNormal(hit.triangle, 1u) * hit.b1 +
             triangleNormal(hit.triangle, 2u) * hit.b2;
    n = dot(n, s.ng) < 0.0 ? -n : n;
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

bool scattersHere(Surface s) { return s.front || (s.m.flags & kMaterialOneSided) == 0u; }
