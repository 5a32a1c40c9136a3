// Scattering. Each BSDF is one file that samples a direction; this one holds what they share and the choice.

// All directions point away from the surface. n: shading normal, ng: geometric normal, both on wo's side.
struct BsdfSample {
  Vec3 wi;
  Vec3 weight;   // f cos / pdf_w, cancelled analytically
  bool specular; // a delta distribution: light sampling can't find what it leads to
};

// Reflection about n; about ng where a shading normal would send it below the surface.
Vec3 reflectAbove(Vec3 wo, Vec3 n, Vec3 ng) {
  Vec3 wi = n * (2.0 * dot(n, wo)) - wo;
  Vec3 geometric = ng * (2.0 * dot(ng, wo)) - wo;
  return dot(wi, ng) > 0.0 ? wi : geometric;
}
