// A path, and what hangs on it. Radiance in W m^-2 sr^-1.

struct Path {
  Ray ray;          // to the next vertex
  Vec3 beta;
  Vec3 L;           // what the path has gathered
  uint bounce;      // scattering events so far: the next vertex's index
  bool emit;        // whether emission at the next vertex counts: light sampling has not counted all of it
  Float pdf_w;      // with which the BSDF sampled ray.d where light sampling could too; 0: emission counts in full
  uint history;     // kinds.glsl; light_path.glsl
  // The other side's density at this end of the path, over area: of the eye's paths at the first vertex, which is
  // connected to the eye, over their number, and 0 where no path from a light leads there; of light sampling on the light.
  Float otherPdf_A;
  Vec3 from;        // of the light tree: where light sampling stood when it could have found what ray.d leads to,
  Vec3 fromNormal;  // and the normal there,
  uint fromTable;   // and its table
  uint reuse;       // reuse.glsl
  uint branch;      // which branches of split vertices the path has taken, a bit each
  uint waiting;     // branches that wait
  uint repeat;      // of the sample's paths through the same point of the image, from 0
  uint repeats;     // how many there are
  uint pixel;       // with sampleLow and key: the counter of the random numbers
  uint sampleLow;
  uint key;
  Float sampleWeight; // of the sample in its pixel
};

CONSTANT uint kLightPathKey = 0x51ED270Bu; // sets random numbers of a path from a light apart from the eye's

UVec4 pathRandom(Path path, uint block) {
  uint key = path.key;
  // Points of one pixel's sequence would go all over the image, where nothing is left of their order.
  if (kFromLight) return independentBlock(path.pixel, path.sampleLow, block, key ^ kLightPathKey);
  if (kEffectSpecularSamples) key ^= MUTATE(RepeatsAlike, path.repeat * 0x27D4EB2Fu, 0u);
  if (kEffectSplitting) key = branchKey(key, path.branch);
  return randomBlock(path.pixel, path.sampleLow, block, key);
}

CONSTANT uint kNoPixel = 0xFFFFFFFFu;

// What a light sends by way of a vertex to the viewer, if nothing is in between.
struct DirectLight {
  Ray shadow;
  Float end;    // of the shadow ray; 0: no light, no ray
  uint target;  // triangle that the shadow ray leads to
  Vec3 L;
  uint history; // of the path that it makes
  uint pixel;   // that a path from a light has met; kNoPixel: the path's own
};

DirectLight noDirectLight() {
  DirectLight d;
  d.shadow.o = Vec3(0.0);
  d.shadow.d = Vec3(0.0, 0.0, 1.0);
  d.shadow.exclude = kNoTriangle;
  d.end = 0.0;
  d.target = kNoTriangle;
  d.L = Vec3(0.0);
  d.history = kHistoryEye;
  d.pixel = kNoPixel;
  return d;
}
