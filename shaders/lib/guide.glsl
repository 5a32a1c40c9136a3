// Guided directions: a path whose first surface is specular is not joined to paths from the lights, and whether a diffuse
// surface that it meets behind that sees a lamp by way of a further specular one is left to chance. There a direction comes
// with probability 1 / kGuideShareInverse from where such light has been seen to arrive before the render, else from the BSDF
// (Jensen 1995, "Importance Driven Path Tracing Using the Photon Map"; both weighted together: Veach 1997, 9.2.4).
// What was learned (src/device/guide.h) is a histogram by place, a grid of cubes, and direction, kGuideEdge^2 bins of a
// square. However poor it is, the image's expectation is the same.

// The octahedral map from unit vectors to [0, 1]^2: Cigolle et al. 2014, JCGT 3(2), 3. Its lower half is folded outwards.
Vec2 foldOctahedron(Vec2 p) {
  return Vec2(p.x < 0.0 ? abs(p.y) - 1.0 : 1.0 - abs(p.y), p.y < 0.0 ? abs(p.x) - 1.0 : 1.0 - abs(p.x));
}
Vec2 toOctahedron(Vec3 d) {
  Float scale = 1.0 / (abs(d.x) + abs(d.y) + abs(d.z));
  Vec2 p = Vec2(d.x, d.y) * scale;
  return (d.z < 0.0 ? foldOctahedron(p) : p) * 0.5 + 0.5;
}
Vec3 fromOctahedron(Vec2 square) {
  Vec2 p = square * 2.0 - 1.0;
  Float z = 1.0 - abs(p.x) - abs(p.y);
  Vec2 q = z < 0.0 ? foldOctahedron(p) : p;
  return normalize(Vec3(q.x, q.y, z));
}

uint guideBinOf(Vec3 d) {
  Vec2 p = toOctahedron(d) * Float(kGuideEdge);
  uint x = min(uint(p.x), kGuideEdge - 1u);
  uint y = min(uint(p.y), kGuideEdge - 1u);
  return y * kGuideEdge + x;
}

// Where the histogram of the cube about p lies; kNoGuide where no light has been seen to arrive.
uint guideAt(Vec3 p) {
  uint cube = cubeAt(p, guideLower(), guideCubesPerMetre(), guideGridEdge(), kNoGuide);
  return cube != kNoGuide ? guideStart(cube) : kNoGuide;
}

// Of a path that light tracing doesn't join.
bool isGuided(Path path) {
  return kEffectGuiding && !kFromLight && guideGridEdge() > 0u && path.bounce > 0u && path.otherPdf_A == 0.0;
}

// At a diffuse surface: b, drawn by the BSDF with these numbers, or a direction of the guide in its place.
BsdfSample guidedSample(Surface s, Vec3 wo, UVec4 random, BsdfSample b) {
  BsdfSample g = b;
  uint guide = guideAt(s.p);
  if (guide != kNoGuide) {
    uint bin = guideBinOf(b.wi);
    if (random.z < kGuideShareBelow) {
      // What is left of the number is a row of the alias table, and what chooses between its owner and its alias.
      uint bits = random.z * kGuideShareInverse;
      bin = bits >> 24u;
      AliasBin row = guideBin(guide, bin);
      if (MUTATE(GuideAliasIgnored, ((bits >> 16u) & 255u) >= row.threshold, false)) bin = row.alias;
      Vec2 corner = Vec2(Float(bin % kGuideEdge), Float(bin / kGuideEdge));
      g.wi = fromOctahedron((corner + Vec2(toUnit(random.x), toUnit(random.y))) * (1.0 / Float(kGuideEdge)));
    }
    Float sum = abs(g.wi.x) + abs(g.wi.y) + abs(g.wi.z); // solid angle over the square's area: 4 sum^3
    Float pdf_w = Float(guideBin(guide, bin).units) * (Float(kGuideBins) / (4.0 * Float(kAliasUnits))) / (sum * sum * sum);
    BsdfValue value = evaluateBsdf(s, wo, g.wi);
    Float both = mix(value.pdf_w, pdf_w, MUTATE(GuideDensityDropped, 1.0 / Float(kGuideShareInverse), 0.0));
    // By the BSDF's density light sampling weighs itself against what is met here: so must this, whatever drew it.
    g.pdf_w = MUTATE(GuideWeighedByBoth, value.pdf_w, both);
    g.weight = scattersTo(s, g.wi) ? value.f * (dot(s.n, g.wi) / both) : Vec3(0.0);
  }
  return g;
}
