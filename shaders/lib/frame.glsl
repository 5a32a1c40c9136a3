// Local frames and warps of the unit square.

CONSTANT Float kPi = 3.14159265358979323846;
CONSTANT Float kInvPi = 0.31830988618379067154;

// Local z is the normal.
struct Frame {
  Vec3 s;
  Vec3 t;
  Vec3 n;
};

// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1); branched at n.z = -1/2 instead of 0,
// since n.z is exactly 0 on common walls.
Frame makeFrame(Vec3 n) {
  Float s = MUTATE(FrisvadFrame, n.z >= -0.5, true) ? 1.0 : -1.0;
  Float a = -1.0 / (s + n.z);
  Float b = n.x * n.y * a;
  Frame f;
  f.s = Vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
  f.t = Vec3(b, s + n.y * n.y * a, -n.y);
  f.n = n;
  return f;
}

Vec3 toWorld(Frame f, Vec3 v) { return f.s * v.x + f.t * v.y + f.n * v.z; }

// Density cos(theta) / pi over solid angle; z > 0 since u.x < 1.
Vec3 squareToCosineHemisphere(Vec2 u) {
  Float r = sqrt(MUTATE(UniformHemisphere, u.x, u.x * (2.0 - u.x)));
  Float phi = 2.0 * kPi * u.y;
  return Vec3(r * cos(phi), r * sin(phi), MUTATE(UniformHemisphere, sqrt(1.0 - u.x), 1.0 - u.x));
}

// Barycentric coordinates (b1, b2), uniform over a triangle's area.
Vec2 squareToTriangle(Vec2 u) {
  Float r = MUTATE(TriangleWarp, sqrt(u.x), u.x);
  return Vec2(r * (1.0 - u.y), r * u.y);
}

Float maxComponent(Vec3 v) { return max(v.x, max(v.y, v.z)); }
Float meanComponent(Vec3 v) { return (v.x + v.y + v.z) * (1.0 / 3.0); }

// The number of the cube about p of a grid, or `outside` where there is none.
uint cubeAt(Vec3 p, Vec3 lower, Float cubesPerMetre, uint edge, uint outside) {
  Vec3 q = (p - lower) * cubesPerMetre;
  bool inside = min(q.x, min(q.y, q.z)) >= 0.0 && maxComponent(q) < Float(edge);
  return inside ? guideCube(uint(q.x), uint(q.y), uint(q.z), edge) : outside;
}
