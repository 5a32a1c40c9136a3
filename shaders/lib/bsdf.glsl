// Scattering. Each BSDF is one file; this one holds what they share, scatter.glsl the choice between them.
// All directions point away from the surface.

struct Surface {
  Vec3 p;
  Vec3 error;
  Vec3 ng;     // geometric normal on the viewer's side
  Vec3 n;      // shading normal on the viewer's side
  Vec3 ns;     // the same, even if the viewer can't see it
  Float doubleArea; // twice that of the triangle
  uint lightLeaf;   // of the light tree, if the triangle is one of its lights
  bool front;  // seen from the side its normal points to
  Material m;
};

struct BsdfSample {
  Vec3 wi;
  Vec3 weight;   // f cos / pdf_w, cancelled analytically where it can be
  Float pdf_w;   // 0: specular
  bool specular; // a delta distribution: light sampling can't find what it leads to
  bool reversible; // specular: light that comes along wi leaves by the same rule along wo
};

struct BsdfValue {
  Vec3 f;
  Float pdf_w; // with which sampling finds this direction
};

Vec3 reflectAbout(Vec3 wo, Vec3 n) { return n * (2.0 * dot(n, wo)) - wo; }

// Reflection about n; about ng where a shading normal would send it below the surface.
Vec3 reflectAbove(Vec3 wo, Vec3 n, Vec3 ng) {
  Vec3 wi = reflectAbout(wo, n);
  return dot(wi, ng) > 0.0 ? wi : reflectAbout(wo, ng);
}

// A sample of a lobe, its weight from the BSDF's value. Where the density rounds to 0 so does f.
BsdfSample smoothSample(Surface s, Vec3 wi, BsdfValue value) {
  BsdfSample b;
  b.wi = wi;
  b.specular = false;
  b.reversible = true;
  b.pdf_w = value.pdf_w;
  b.weight = value.pdf_w > 0.0 ? value.f * (abs(dot(s.n, wi)) / value.pdf_w) : Vec3(0.0);
  return b;
}

BsdfSample specularSample(Vec3 wi, Vec3 weight) {
  BsdfSample s;
  s.wi = wi;
  s.weight = weight;
  s.pdf_w = 0.0;
  s.specular = true;
  s.reversible = true;
  return s;
}

// Of a mirror or a metal.
BsdfSample reflectedSample(Surface s, Vec3 wo, Vec3 weight) {
  BsdfSample b = specularSample(reflectAbove(wo, s.n, s.ng), weight);
  b.reversible = dot(s.ns, wo) > 0.0 && dot(reflectAbout(wo, s.n), s.ng) > 0.0;
  return b;
}
