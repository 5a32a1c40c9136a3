// Microfacets: how their normals h are distributed (D), Smith's masking, and sampling of the normals that a
// direction sees. Isotropic; alpha > 0, with Beckmann's distribution the root mean square of the facets' slopes.
// Cosines are with the surface's mean normal. Walter et al. 2007, "Microfacet Models for Refraction through Rough
// Surfaces"; Heitz 2014, "Understanding the Masking-Shadowing Function", JCGT 3(2).

CONSTANT Float kInvSqrtPi = 0.56418958354775628695;

// One of the two distributions is compiled in, or both; where one is left out, its surfaces have the other's facets.
bool isBeckmann(Material m) {
  return kEffectBeckmann && (!kEffectGgx || (m.flags & kMaterialBeckmann) != 0u);
}

// Cosine and squared sine of the angle between n and h, both unit; the sine without the cancellation of 1 - cos^2,
// which would lose the peak of a nearly smooth surface.
Vec2 facetAngle(Vec3 n, Vec3 h) {
  Vec3 across = cross(n, h);
  return Vec2(dot(n, h), MUTATE(FacetSineCancels, dot(across, across), 1.0 - dot(n, h) * dot(n, h)));
}

// D, per steradian, at facetAngle() `h`; Walter et al., eq. 25 and 33.
Float facetDensity(Float alpha, bool beckmann, Vec2 h) {
  Float alpha2 = alpha * alpha;
  Float cos2 = max(h.x * h.x, 1e-16); // the power of 4 stays a float; Beckmann's D is 0 long before
  Float ggx = cos2 + h.y / alpha2;
  Float density = beckmann ? exp(-h.y / (cos2 * alpha2)) / (cos2 * cos2) : 1.0 / (ggx * ggx);
  return density * kInvPi / alpha2;
}

// (1 - erf(x)) exp(x^2), x >= 0: Abramowitz and Stegun 1964, 7.1.26, error below 1.5e-7.
Float scaledErfc(Float x) {
  Float t = 1.0 / (1.0 + 0.3275911 * x);
  return ((((1.061405429 * t - 1.453152027) * t + 1.421413741) * t - 0.284496736) * t + 0.254829592) * t;
}

// Smith's masking of a direction at cosine z >= 0, as 2 z (1 + Lambda), which is finite at grazing incidence and
// never 0: G1 is 2 z over it. Heitz 2014, eq. 68 and 72.
Float smithTerm(Float alpha, bool beckmann, Float z) {
  Float spread = alpha * sqrt(max(1.0 - z * z, 0.0));
  Float nu = z / max(spread, 0.1 * z); // beyond 10, erf is 1
  Float tail = exp(-nu * nu);
  Float bell = z * (2.0 - scaledErfc(nu) * tail) + spread * tail * kInvSqrtPi;
  return beckmann ? bell : z + sqrt(z * z + spread * spread);
}

// Masking of both directions, correlated by height (Heitz 2014, eq. 99), as 2 zo zi / G2; to, ti: their smithTerm().
Float smithBoth(Float zo, Float to, Float zi, Float ti) {
  return MUTATE(MaskingDropped, zi * to + zo * (ti - 2.0 * zi), 2.0 * zo * zi);
}

// erf^-1(q - 1), q in (0, 2): Giles 2010, "Approximating the erfinv function", single precision; a relative error
// of 4e-7. By q, so that the left tail is not lost.
Float inverseErf(Float q) {
  Float w = -log(q * (2.0 - q));
  Float a = w - 2.5;
  Float central = 3.43273939e-07 + 2.81022636e-08 * a;
  central = -4.39150654e-06 + (-3.5233877e-06 + central * a) * a;
  central = -0.00125372503 + (0.00021858087 + central * a) * a;
  central = 0.246640727 + (-0.00417768164 + central * a) * a;
  central = 1.50140941 + central * a;
  Float b = sqrt(max(w, 0.0)) - 3.0;
  Float outer = 0.000100950558 - 0.000200214257 * b;
  outer = -0.00367342844 + (0.00134934322 + outer * b) * b;
  outer = -0.0076224613 + (0.00573950773 + outer * b) * b;
  outer = 1.00167406 + (0.00943887047 + outer * b) * b;
  outer = 2.83297682 + outer * b;
  return (w < 5.0 ? central : outer) * (q - 1.0);
}

// One step of Newton's method for visibleSlope(): its left side is concave in q, so steps come from the left.
Float slopeStep(Float q, Float z, Float sinTheta, Float target) {
  Float x = inverseErf(q);
  Float value = z * q + sinTheta * exp(-x * x) * kInvSqrtPi - target;
  return clamp(q - value / (z - sinTheta * x), 0.25 * q, 1.9999999);
}

// A slope x towards a viewer at cosine z, of a Beckmann surface of alpha 1, with density proportional to
// max(z - x sin, 0) exp(-x^2). Solves  z (1 + erf x) + sin exp(-x^2) / sqrt(pi) = u smithTerm  for q = 1 + erf x:
// Heitz and d'Eon 2014, "Importance Sampling Microfacet-Based BSDFs using the Distribution of Visible Normals", as
// Jakob 2014, "An Improved Visible Normal Sampling Routine for the Beckmann Distribution", starts it. From there
// three steps reach 2e-7 of the distribution function everywhere; no loop, since lavapipe counts them.
Float visibleSlope(Float z, Float sinTheta, Float u) {
  Float from = max(u, 2.98023224e-8); // half of the least step of u: 0 has an infinite slope
  Float theta = atan(sinTheta, z);
  Float fit = 1.0 + theta * (-0.876 + theta * (0.4265 - 0.0594 * theta));
  Float cotangent = z / max(sinTheta, 0.1 * z);
  Float most = 2.0 - scaledErfc(cotangent) * exp(-cotangent * cotangent);
  Float target = from * smithTerm(1.0, true, z);
  Float q = clamp(most * (1.0 - pow(1.0 - from, fit)), 1e-9, 1.9999999);
  Float solved = slopeStep(slopeStep(slopeStep(q, z, sinTheta, target), z, sinTheta, target), z, sinTheta, target);
  return inverseErf(MUTATE(SlopeNotSolved, solved, q));
}

// Normals that w sees on a surface of alpha 1, not normalised; w unit, w.z >= 0.
Vec3 visibleBeckmann(Vec3 w, Vec2 u) {
  Float sinTheta = sqrt(w.x * w.x + w.y * w.y);
  Vec2 towards = sinTheta > 0.0 ? Vec2(w.x, w.y) / sinTheta : Vec2(1.0, 0.0);
  Float along = visibleSlope(w.z, sinTheta, u.x);
  Float across = inverseErf(2.0 * u.y + 5.9604644775390625e-8); // the step of u, halved: never 0 or 2
  return Vec3(-(towards.x * along - towards.y * across), -(towards.y * along + towards.x * across), 1.0);
}
// Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps": uniform over the cap of directions
// that a sphere reflects w to, then half way to w.
Vec3 visibleGgx(Vec3 w, Vec2 u) {
  Float phi = 2.0 * kPi * u.x;
  Float below = u.y * (1.0 + w.z); // the pole
  Float r = sqrt(max(below * (2.0 - below), 0.0));
  return Vec3(w.x + r * cos(phi), w.y + r * sin(phi), (1.0 - u.y) * (1.0 + w.z));
}

// A normal that wo sees, with density 2 D (wo . h) / smithTerm(wo) per steradian; both in the local frame, wo.z >= 0.
Vec3 sampleVisibleNormal(Float alpha, bool beckmann, Vec3 wo, Vec2 u) {
  Vec3 stretched = normalize(Vec3(alpha * wo.x, alpha * wo.y, wo.z));
  if (MUTATE(AllNormalsVisible, false, true)) stretched = Vec3(0.0, 0.0, 1.0);
  Vec3 h = beckmann ? visibleBeckmann(stretched, u) : visibleGgx(stretched, u);
  return normalize(Vec3(alpha * h.x, alpha * h.y, h.z));
}

// What a facet that mirrors wo to wi, or refracts it there, makes of the surface.
struct FacetValue {
  Float f; // without Fresnel's share
  Float pdf_w;
};

// h: the facet's normal, on n's side; spread: 2 (wo . h) dh/dwi, the Jacobian of the facet's optics. The cosine of
// wo in the density of visible normals is in `spread`, where it may cancel.
FacetValue facetValue(Float alpha, bool beckmann, Vec3 wo, Vec3 wi, Vec3 n, Vec3 h, Float spread) {
  Float zo = max(dot(n, wo), 0.0);
  Float zi = abs(dot(n, wi));
  Float to = smithTerm(alpha, beckmann, zo);
  Float density = facetDensity(alpha, beckmann, facetAngle(n, h)) * spread;
  FacetValue value;
  value.f = density / smithBoth(zo, to, zi, smithTerm(alpha, beckmann, zi));
  value.pdf_w = density / to;
  return value;
}
CONSTANT Float kReflectionSpread = 0.5; // dh/dwi is 1 / (4 wo . h): Walter et al., eq. 14

// A facet that wo sees, in the local frame of the surface.
struct Facet {
  Frame frame;
  Vec3 wo;
  Vec3 h;
  Float cosH;    // between wo and h
  Float density; // D
  Float masking; // smithTerm() of wo
};

Vec3 toLocal(Frame f, Vec3 v) { return Vec3(dot(f.s, v), dot(f.t, v), dot(f.n, v)); }

Facet sampleFacet(Float alpha, bool beckmann, Vec3 wo, Vec3 n, Vec2 u) {
  Facet facet;
  facet.frame = makeFrame(n);
  facet.wo = toLocal(facet.frame, wo);
  facet.wo.z = max(facet.wo.z, 0.0);
  facet.h = sampleVisibleNormal(alpha, beckmann, facet.wo, u);
  facet.cosH = clamp(dot(facet.wo, facet.h), 0.0, 1.0);
  facet.density = facetDensity(alpha, beckmann, Vec2(facet.h.z, facet.h.x * facet.h.x + facet.h.y * facet.h.y));
  facet.masking = smithTerm(alpha, beckmann, facet.wo.z);
  return facet;
}

// The sample that leaves the facet towards wi, in its frame, Fresnel's share taken; its weight is G2 / G1, in which
// the peak of D cancels.
BsdfSample facetSample(Facet facet, Float alpha, bool beckmann, Vec3 wi, Float spread) {
  Float zi = abs(wi.z);
  BsdfSample s;
  s.wi = normalize(toWorld(facet.frame, wi));
  s.weight =
      Vec3(zi * facet.masking / smithBoth(facet.wo.z, facet.masking, zi, smithTerm(alpha, beckmann, zi)));
  s.pdf_w = facet.density * spread / facet.masking;
  s.specular = false;
  s.reversible = true;
  return s;
}
