// Paths from the lights, joined to the eye: what light sampling can't find, light that a specular surface has sent on
// (L S+ ... D E). Every sample of a pixel comes with one such path, whose splats go all over the image. They are traced
// by a kernel of their own (kFromLight): on lavapipe either kind would pay for what the other does at a vertex.
//
// The eye's own paths find the same light where they happen to hit the emitter. Both are weighted by their densities at
// the eye's first vertex (Veach 1997, 9.2 and 10.2): with BSDFs sampled alike in both directions, all other factors of
// the two cancel, since light keeps its etendue on the way. Where they don't quite, any weights that both sides
// compute alike leave the image's expectation as it is. A vertex that sends light another way back than it came, as
// shading normals can, belongs to the eye's paths alone.

// Histories of a path from a light; L, then S: reflected, transmitted, transmitted twice, any other.
CONSTANT uint kLightReflected = 1u;
CONSTANT uint kLightTransmitted = 2u;
CONSTANT uint kLightThrough = 3u;
CONSTANT uint kLightOther = 4u;
CONSTANT uint kLightScattered = 5u; // any other, and D last

uint lightAfterSpecular(uint history, bool transmitted) {
  if (history == kHistoryLight) return transmitted ? kLightTransmitted : kLightReflected;
  return history == kLightTransmitted && transmitted ? kLightThrough : kLightOther;
}
uint lightKind(uint history) {
  return history == kLightReflected || history == kLightThrough ? kKindCaustic : kKindIndirectCaustic;
}

// Density over area with which the eye's paths, one a pixel, begin at a point, over the number of pixels.
// r2: squared distance from the eye; cosAxis: of the direction there and the camera's axis.
Float eyePdf_A(Float r2, Float cosSurface, Float cosAxis) {
  Float cube = MUTATE(AxisCosineDropped, cosAxis * cosAxis * cosAxis, 1.0);
  return cosSurface / (r2 * cube * cameraImageArea());
}

// The start of a path from a light that is chosen by its power; one that is no triangle sends none.
Path lightPath(uint pixel, uint sampleLow, uint key) {
  Path path;
  path.branch = 0u;
  path.pixel = pixel;
  path.sampleLow = sampleLow;
  path.key = key;
  UVec4 random = pathRandom(path, kBlockCamera);
  UVec4 more = pathRandom(path, kBlockCamera + 1u);
  Vec2 point;
  LightRecord light = chooseByPower(random, point);
  Vec2 b = squareToTriangle(point);
  Vec3 n = cross(light.v1 - light.v0, light.v2 - light.v0);
  Float doubleArea = length(n);
  bool emits = light.triangle < kLightEnvironment && doubleArea > 0.0;
  Vec3 ng = emits ? n / doubleArea : Vec3(0.0, 0.0, 1.0);
  Vec3 p = light.v0 + (light.v1 - light.v0) * b.x + (light.v2 - light.v0) * b.y;
  Vec3 local = squareToCosineHemisphere(Vec2(toUnit(more.x), toUnit(more.y)));
  path.otherPdf_A = light.probability * 2.0 / doubleArea;
  path.ray.d = normalize(toWorld(makeFrame(ng), local));
  path.ray.o = offsetRayOrigin(p, positionError(light.v0, light.v1, light.v2), ng, path.ray.d);
  path.ray.exclude = light.triangle;
  path.beta = emits ? light.radiance * (kPi / path.otherPdf_A) : Vec3(0.0);
  path.L = Vec3(0.0);
  path.bounce = 0u;
  path.emit = false;
  path.pdf_w = 0.0;
  path.history = kHistoryLight;
  path.waiting = 0u;
  path.repeat = 0u;
  path.repeats = 1u;
  path.sampleWeight = 1.0;
  path.from = path.ray.o;
  path.fromNormal = Vec3(0.0);
  path.fromTable = 0u;
  path.reuse = kReuseNone;
  return path;
}

bool meetsBox(Ray ray, Vec3 lower, Vec3 upper) {
  Vec3 inverse = Vec3(inverseOf(ray.d.x, 0.0), inverseOf(ray.d.y, 0.0), inverseOf(ray.d.z, 0.0));
  Vec3 a = (lower - ray.o) * inverse;
  Vec3 b = (upper - ray.o) * inverse;
  Vec3 near = min(a, b);
  Vec3 far = max(a, b);
  return max(maxComponent(near), 0.0) <= min(far.x, min(far.y, far.z));
}

// Whether a path from a light may have a specular surface as its first vertex, as it must.
bool mayBecomeCaustic(Ray ray) {
  bool may = false;
  for (uint i = 0u; i < kSpecularBoxes; ++i) may = may || meetsBox(ray, specularLower(i), specularUpper(i));
  return may;
}

// What a vertex of a path from a light sends to the eye, and to which pixel. wo: towards the vertex before.
DirectLight connectToEye(Path path, Surface s, Vec3 wo) {
  Vec3 toEye = cameraEye() - s.p;
  Float r2 = dot(toEye, toEye);
  Vec3 w = toEye / sqrt(r2);
  Surface seen = seenFrom(s, w);
  Vec3 origin = offsetRayOrigin(s.p, s.error, s.ng, w);
  Vec3 span = cameraEye() - origin;
  Float distance = length(span);
  Float cosAxis = -dot(w, cameraForward());
  Vec3 onImage = w / -cosAxis - cameraUpperLeft(); // the image plane lies at distance 1
  Vec3 right = cameraRight();
  Vec3 down = cameraDown();
  Float u = dot(onImage, right) / dot(right, right);
  Float v = dot(onImage, down) / dot(down, down);
  bool inImage = cosAxis > 0.0 && u >= 0.0 && u < 1.0 && v >= 0.0 && v < 1.0;
  bool scattered = isSmooth(s.m.bsdf) && scattersHere(seen) && scattersTo(seen, wo);
  bool wanted = !kEffectPathKinds || ((pathKinds() >> lightKind(path.history)) & 1u) != 0u;
  bool joined = path.bounce > 0u && inImage && scattered && wanted;
  Float pdf_A = eyePdf_A(r2, abs(dot(s.ng, w)), cosAxis);
  bool isShared = reusesPaths() && path.history == kLightScattered;
  Float weight = misWeight(path.otherPdf_A, MUTATE(ReuseWeighsByEye, isShared ? sharedEyePdf_A() : pdf_A, pdf_A));
  BsdfValue bsdf = evaluateBsdf(seen, w, wo);
  // Flux arrives by the cosine of the triangle, the BSDF counts that of the shading normal: Veach 1997, 5.3.2.
  Float shading = abs(dot(seen.n, wo)) / abs(dot(s.ng, wo));
  DirectLight d = noDirectLight();
  d.shadow.o = origin;
  d.shadow.d = span / distance;
  d.end = joined ? distance : 0.0;
  d.L = joined ? path.beta * bsdf.f * (shading * pdf_A * weight) : Vec3(0.0);
  uint x = min(uint(clamp(u, 0.0, 1.0) * Float(imageWidth())), imageWidth() - 1u);
  uint y = min(uint(clamp(v, 0.0, 1.0) * Float(imageHeight())), imageHeight() - 1u);
  d.pixel = y * imageWidth() + x;
  return d;
}

// The weight of a sampled direction where light arrives along wo and goes on along b.wi, towards the eye: the BSDF as
// the eye's path would see it, over the density with which it was sampled the other way.
Vec3 adjointWeight(Surface s, Vec3 wo, BsdfSample b) {
  Surface seen = seenFrom(s, b.wi);
  Float cosines = abs(dot(s.ng, b.wi)) / abs(dot(s.ng, wo));
  if (b.specular) {
    // Radiance isn't scaled at refraction, flux knows of no such choice: the square of the indices makes up for it.
    bool transmitted = dot(b.wi, s.ng) < 0.0;
    Float index = transmitted ? (s.front ? 1.0 / s.m.ior : s.m.ior) : 1.0;
    Float shading = MUTATE(ShadingAdjointDropped, cosines * abs(dot(s.n, wo)) / abs(dot(seen.n, b.wi)), 1.0);
    bool joined = MUTATE(IrreversibleJoined, b.reversible, true);
    return joined ? b.weight * (shading * MUTATE(IndexAdjointDropped, index * index, 1.0)) : Vec3(0.0);
  }
  bool scattered = b.pdf_w > 0.0 && scattersHere(seen) && scattersTo(seen, wo);
  return scattered ? evaluateBsdf(seen, b.wi, wo).f * (cosines * abs(dot(seen.n, wo)) / b.pdf_w) : Vec3(0.0);
}

// x >= 0 as an integer: rounded up with the probability of its fraction, by u.
WideCount roundedAtRandom(Float x, Float u) {
  Float whole = floor(x);
  if (u < x - whole) whole += 1.0;
  Float high = floor(whole * 2.3283064365386963e-10); // 2^-32
  WideCount n;
  n.high = uint(high);
  n.low = uint(whole - high * 4294967296.0);
  return n;
}

// Adds radiance that a path from a light has brought to a pixel. part: of the paths.
void splat(uint pixel, uint part, Vec3 L) {
  Float most = maxComponent(L);
  Float largest = max(most * splatUnits(), most * most * splatSquareUnits());
  if (!(largest < 4.6e18)) { // 2^62
    reportNonFinite();
    return;
  }
  UVec4 random = pcg4d(UVec4(orderKey(L.x), orderKey(L.y), orderKey(L.z), pixel));
  WideCount r = roundedAtRandom(L.x * splatUnits(), toUnit(random.x));
  WideCount g = roundedAtRandom(L.y * splatUnits(), toUnit(random.y));
  WideCount b = roundedAtRandom(L.z * splatUnits(), toUnit(random.z));
  uint first = pixel * kSplatNumbers;
  addToSplat(first, r);
  addToSplat(first + 2u, roundedAtRandom(L.x * L.x * splatSquareUnits(), toUnit(random.x << 8u)));
  addToSplat(first + 4u, g);
  addToSplat(first + 6u, roundedAtRandom(L.y * L.y * splatSquareUnits(), toUnit(random.y << 8u)));
  addToSplat(first + 8u, b);
  addToSplat(first + 10u, roundedAtRandom(L.z * L.z * splatSquareUnits(), toUnit(random.z << 8u)));
  uint sums = imageWidth() * imageHeight() * kSplatNumbers + (part % kSplatParts) * 6u;
  addToSplat(sums, r);
  addToSplat(sums + 2u, g);
  addToSplat(sums + 4u, b);
}
