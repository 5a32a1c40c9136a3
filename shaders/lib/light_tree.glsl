// The choice of a light by a tree over them: Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with
// Adaptive Tree Splitting", PACMCGIT 1(2); the bounds as in Pharr, Jakob, Humphreys, PBRT 4th ed., 12.6.3.

bool choosesByTree() { return kEffectLightTree && kByLightTree; }

// Bounds of cosines are as good as rounding lets them be: none is taken for 0.
CONSTANT Float kLeastCosine = 0.0009765625;
CONSTANT Float kBelowOne = 0.999999940395355224609375; // 1 - 2^-24

// cos(max(a - b, 0)) of two angles.
Float cosineOfLess(Float cosA, Float cosB) {
  Float sines = sqrt(max((1.0 - cosA * cosA) * (1.0 - cosB * cosB), 0.0));
  return cosA > cosB ? 1.0 : cosA * cosB + sines;
}

// What a node's lights may bring to a surface at p at most, up to a factor. n: the surface's normal; 0: light matters
// from both sides. That the lights lie anywhere in a sphere, seen under an angle b to each side, is allowed for by
// cos(a - b) <= cos a + sin b.
Float lightImportance(LightNode node, Vec3 p, Vec3 n) {
  Vec3 toCentre = node.centre - p;
  Float r2 = max(dot(toCentre, toCentre), node.radius * node.radius);
  Float inverse = 1.0 / sqrt(r2);
  Float sine = node.radius * inverse;
  Float cosSurface = dot(n, n) == 0.0 ? 1.0 : dot(n, toCentre) * inverse + sine;
  Float cosLight = cosineOfLess(-dot(node.axis, toCentre) * inverse, node.cosSpread) + sine;
  return node.power * clamp(cosLight, kLeastCosine, 1.0) * clamp(cosSurface, kLeastCosine, 1.0) * (inverse * inverse);
}

// With which the first of two siblings is chosen: a multiple of 2^-24, as the number is that decides, never 0 or 1.
Float firstShare(LightNode a, LightNode b, Vec3 p, Vec3 n) {
  Float first = lightImportance(a, p, n);
  Float second = lightImportance(b, p, n);
  Float share = first + second > 0.0 ? first / (first + second) : 0.5;
  return clamp(floor(share * 16777216.0 + 0.5), 1.0, 16777215.0) * 5.9604644775390625e-8;
}

// What is left of the number by which the choice fell is as good as a new one: points of all lights together are well
// spread. At every level the bits that it has used up come anew, from random.x.
LightRecord chooseByTree(Vec3 p, Vec3 n, UVec4 random, OUT(Vec2) point) {
  Float u = toUnit(random.z);
  uint bits = random.x;
  Float probability = 1.0;
  uint below = lightNode(0u).below;
  uint levels = 0u;
  do {
    if ((below & kLightLeaf) == 0u) {
      LightNode a = lightNode(below);
      LightNode b = lightNode(below + 1u);
      Float share = firstShare(a, b, p, n);
      bool first = u < share;
      bits = bits * 1664525u + 1013904223u;
      Float rest = (first ? u : u - share) + toUnit(bits) * 5.9604644775390625e-8;
      share = first ? share : 1.0 - share;
      u = min(rest / share, kBelowOne);
      probability *= MUTATE(TreeShareDropped, share, 0.5);
      below = first ? a.below : b.below;
    }
    levels += 1u;
  } while ((below & kLightLeaf) == 0u);
  reportLightWalk(levels);
  point = Vec2(u, toUnit(random.w));
  LightRecord light = lightRecord(below & ~kLightLeaf);
  light.probability = probability;
  return light;
}

// With which a light is chosen so, by its leaf; 1 for the root, and where it is not asked for.
Float treeProbability(uint leaf, bool wanted, Vec3 p, Vec3 n) {
  Float probability = 1.0;
  uint node = wanted ? leaf : 0u;
  uint levels = 0u;
  do {
    if (node != 0u) {
      LightNode a = lightNode(node & ~1u);
      LightNode b = lightNode(node | 1u);
      Float share = firstShare(a, b, p, n);
      probability *= (node & 1u) == 0u ? share : 1.0 - share;
      node = lightNodeParent(node);
    }
    levels += 1u;
  } while (node != 0u);
  reportLightWalk(levels);
  return probability;
}
