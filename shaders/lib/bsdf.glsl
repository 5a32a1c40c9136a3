// Scattering. Each BSDF is one file; this one holds what they share, scatter.glsl the choice between them.
// All directions point away from the surface.

struct Surface {
  Vec3 p;
  Vec3 error;
  Vec3 ng;     // geometric normal on the viewer's side
  Vec3 n;      // shading normal on the viewer's side
  bool front;  // seen from the side its normal points to
  Material m;
};

struct BsdfSample {
  Vec3 wi;
  Vec3 weight;   // f cos / pdf_w, cancelled analytically where it can be
  Float pdf_w;   // 0: specular
  bool specular; // a delta distribution: light sampling can't find what it leads to
};

struct BsdfValue {
  Vec3 f;
  Float pdf_w; // with which sampling finds this direction
};

// Reflection about n; about ng where a shading normal would send it below the surface.
Vec3 reflectAbove(Vec3 wo, Vec3 n, Vec3 ng) {
  Vec3 wi = n * (2.0 * dot(n, wo)) - wo;
  Vec3 geometric = ng * (2.0 * dot(ng, wo)) - wo;
  return dot(wi, ng) > 0.0 ? wi : geometric;
}

// A sample of a lobe, its weight from the BSDF's value. Where the density rounds to 0 so does f.
BsdfSample smoothSample(Surface s, Vec3 wi, BsdfValue value) {
  BsdfSample b;
  b.wi = wi;
  b.specular = false;
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
  return s;
}
