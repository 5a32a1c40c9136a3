// What the library does not do: geometry as textbooks have it. Only in a test build (VKPT_MUTATIONS), to show that the
// checks notice, and to measure what stability costs.

bool isNaive(uint mutation) { return kMutation == mutation || kMutation == kMutationNaiveGeometry; }

// Moeller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection", with their absolute epsilon.
bool intersectNaively(Ray ray, Vec3 v0, Vec3 v1, Vec3 v2, OUT(Float) t, OUT(Float) b1, OUT(Float) b2) {
  Vec3 e1 = v1 - v0;
  Vec3 e2 = v2 - v0;
  Vec3 p = cross(ray.d, e2);
  Float det = dot(e1, p);
  Float scale = 1.0 / det;
  Vec3 s = ray.o - v0;
  Vec3 q = cross(s, e1);
  b1 = dot(s, p) * scale;
  b2 = dot(ray.d, q) * scale;
  t = dot(e2, q) * scale;
  return abs(det) > 1e-8 && b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0 && t > 0.0;
}

// An absolute epsilon.
Vec3 offsetNaively(Vec3 p, Vec3 ng, Vec3 w) { return p + ng * (dot(ng, w) < 0.0 ? -1e-4 : 1e-4); }
