// The choice of a light by a tree over them: Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights with
// Adaptive Tree Splitting", PACMCGIT 1(2); the bounds as in Pharr, Jakob, Humphreys, PBRT 4th ed., 12.6.3.
//
// The way from the root down is the same for places close to each other: for every cube of a grid that holds surfaces, and
// every side that these face, a table chooses from a cut through the tree, at most 2^kMostLightTableBits of its nodes (cells
// and clusters of lights: Vevoda, Kondapaneni, Krivanek 2018, "Bayesian Online Regression for Adaptive Direct Illumination
// Sampling", ACM TOG 37(4)). Elsewhere a table by power stands in. The tree decides what lies below the cut, and all where
// the cubes are too large for lights so small and close.

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

// The side that a normal shows to: 2 a or 2 a + 1, up or down its longest axis; 0 shows to any.
uint lightGridSide(Vec3 n) {
  Vec3 a = abs(n);
  uint axis = a.x >= a.y && a.x >= a.z ? 0u : (a.y >= a.z ? 1u : 2u);
  Float along = axis == 0u ? n.x : (axis == 1u ? n.y : n.z);
  return along == 0.0 ? kAnySide : 2u * axis + (along < 0.0 ? 1u : 0u);
}

// Where the table for a surface at p of normal n begins among the numbers of the grid.
uint lightTableAt(Vec3 p, Vec3 n) {
  uint cube = cubeAt(p, lightGridLower(), lightGridCubesPerMetre(), kLightGridEdge, kLightGridCubes);
  return lightGridNumber(cube * kLightGridSides + lightGridSide(n));
}
AliasBin lightBin(uint table, uint bin) { return unpackBin(lightGridNumber(table + bin), kLightTableBits); }
Float binProbability(AliasBin bin) { return Float(bin.units) * (1.0 / Float(kAliasUnits)); }

// What is left of the number by which the choice fell is as good as a new one: points of all lights together are well
// spread. At every choice the bits that it has used up come anew, from random.x.
struct LightDescent {
  uint below; // of a node of the light tree
  Float probability;
  Float u; // what is left
};

// To a node of the cut.
LightDescent descendByTable(Vec3 p, Vec3 n, UVec4 random) {
  uint table = lightTableAt(p, n);
  uint chosen = random.z >> (32u - kLightTableBits);
  uint left = random.z & (0xFFFFFFFFu >> kLightTableBits);
  Float inRow = (Float(left) + toUnit(random.x)) * 1.52587890625e-5; // 2^-16: in units
  Float units = Float(kAliasUnits >> kLightTableBits);
  AliasBin bin = lightBin(table, chosen);
  Float threshold = Float(bin.threshold);
  bool owner = MUTATE(TableAliasIgnored, inRow < threshold, true);
  if (!owner) chosen = bin.alias;
  LightDescent d;
  d.u = min(owner ? inRow / threshold : (inRow - threshold) / (units - threshold), kBelowOne);
  d.probability = MUTATE(TableShareDropped, binProbability(lightBin(table, chosen)), units / Float(kAliasUnits));
  d.below = chosen | kLightLeaf; // where every light has its bin
  if (kBelowLightTables) d.below = lightGridNumber((kLightGridCubes + 1u) * kLightGridSides + chosen);
  return d;
}

// On to a light.
LightDescent descendByTree(LightDescent from, Vec3 p, Vec3 n, uint bits) {
  LightDescent d = from;
  uint levels = 0u;
  do {
    if ((d.below & kLightLeaf) == 0u) {
      LightNode a = lightNode(d.below);
      LightNode b = lightNode(d.below + 1u);
      Float share = firstShare(a, b, p, n);
      bool first = d.u < share;
      bits = bits * 1664525u + 1013904223u;
      Float rest = (first ? d.u : d.u - share) + toUnit(bits) * 5.9604644775390625e-8;
      share = first ? share : 1.0 - share;
      d.u = min(rest / share, kBelowOne);
      d.probability *= MUTATE(TreeShareDropped, share, 0.5);
      d.below = first ? a.below : b.below;
    }
    levels += 1u;
  } while ((d.below & kLightLeaf) == 0u);
  reportLightWalk(levels);
  return d;
}

LightRecord chooseByTree(Vec3 p, Vec3 n, UVec4 random, OUT(Vec2) point) {
  LightDescent d;
  d.u = toUnit(random.z);
  d.probability = 1.0;
  if (kByLightTables) d = descendByTable(p, n, random);
  else d.below = lightNode(0u).below;
  if (kBelowLightTables) d = descendByTree(d, p, n, random.x);
  point = Vec2(d.u, toUnit(random.w));
  LightRecord light = lightRecord(d.below & ~kLightLeaf);
  light.probability = d.probability;
  return light;
}

// With which a light is chosen so, by its leaf, or by its bin where each light has one of its own; `table` as lightTableAt()
// gives it for p and n. Of no meaning where it is not wanted.
Float treeProbability(uint leaf, bool wanted, Vec3 p, Vec3 n, uint table) {
  Float probability = 1.0;
  uint node = wanted ? leaf : 0u;
  if (kBelowLightTables) {
    uint levels = 0u;
    LightNodePlace place = lightNodePlace(node);
    do {
      if (node != 0u && !(kByLightTables && place.bin > 0u)) {
        LightNode a = lightNode(node & ~1u);
        LightNode b = lightNode(node | 1u);
        Float share = firstShare(a, b, p, n);
        probability *= (node & 1u) == 0u ? share : 1.0 - share;
        node = place.parent;
        place = lightNodePlace(node);
      }
      levels += 1u;
    } while (node != 0u && !(kByLightTables && place.bin > 0u));
    reportLightWalk(levels);
    if (kByLightTables) node = max(place.bin, 1u) - 1u;
  }
  if (kByLightTables) probability *= binProbability(lightBin(table, node));
  return probability;
}
