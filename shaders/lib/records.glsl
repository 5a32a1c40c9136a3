// What the accessors return. Each program reads its own memory: texel buffers on the device (device_memory.glsl),
// arrays on the host (src/host/program.inl).

struct TriangleRecord {
  Vec3 v0;
  Vec3 v1;
  Vec3 v2;
  uint material;
  uint id; // in input order
  uint lightLeaf; // of the light tree, or bin of its tables, if the triangle is one of its lights: treeProbability()
};

// A light, and the row of the alias table with the same index.
struct LightRecord {
  Vec3 v0; // point: its position; directional: the unit direction to it
  Vec3 v1;
  Vec3 v2;
  Vec3 radiance;     // point: W/sr; directional: W/m^2
  Float probability; // with which the light is chosen
  uint triangle;     // in BVH order; kLightPoint, kLightDirectional or kLightEnvironment
  Float threshold;   // the row keeps itself when the second number is below
  uint alias;
};

// A node of the light tree: what it knows of the lights below.
struct LightNode {
  Vec3 centre; // of a sphere about them
  Float radius;
  Vec3 axis; // of the cone of their normals
  Float cosSpread;
  Float power; // share of all power
  uint below;  // the first of two children side by side, or kLightLeaf and the light
};

// Where a node stands in the light tree.
struct LightNodePlace {
  uint parent;
  uint bin; // of the tables of the grid of lights, and one; 0: none chooses this node
};

// Ten bits a component, from -1 to 1.
Vec3 lightAxis(uint packed) {
  Vec3 steps = Vec3(Float(packed & 1023u), Float((packed >> 10u) & 1023u), Float((packed >> 20u) & 1023u));
  return (steps - 511.0) * (1.0 / 511.0);
}

struct EnvironmentRecord {
  Vec3 radiance;
  Float pdf_w;     // of light sampling, given that it chooses the environment
  Float threshold; // of the alias table's row, as in LightRecord
  uint alias;
};

// One of 2^bits bins, of directions or of lights, and the row of their alias table with the same index.
struct AliasBin {
  uint units;     // the bin's share, of kAliasUnits
  uint threshold; // the row keeps itself when a number, of kAliasUnits / 2^bits, is below
  uint alias;
};
AliasBin unpackBin(uint packed, uint bits) {
  AliasBin bin;
  bin.units = packed & 65535u;
  bin.threshold = (packed >> 16u) & ((65536u >> bits) - 1u);
  bin.alias = packed >> (32u - bits);
  return bin;
}

struct Material {
  uint bsdf;
  uint flags;       // kMaterialOneSided, ...
  Vec3 reflectance; // diffuse: albedo; mirror: reflectance; phong, microfacet: kd
  uint texture;     // multiplies reflectance; kNoTexture: none
  Vec3 emission;    // radiance of the front side
  Float lightPdf_A; // of light sampling on emissive triangles with this material: 1/m^2, choice included
  Vec3 specular;    // phong, microfacet: ks
  Float roughness;  // phong: exponent; rough materials: alpha
  Float ior;        // dielectric: index behind the surface over the index in front of it
  Vec3 eta;         // conductor: complex index of refraction
  Vec3 k;
  Vec3 absorption;  // dielectric: 1/m, behind the surface
};
CONSTANT uint kNoTexture = 0xFFFFFFFFu;

struct TextureRecord {
  uint first; // pixel
  uint width;
  uint height;
};

// An integer of 64 bits.
struct WideCount {
  uint low;
  uint high;
};

// A branch of a path that waits until the other one has ended: specular, so its emission counts in full.
struct Branch {
  Vec3 o;
  uint exclude;
  Vec3 d;
  uint branch;
  Vec3 beta;
  uint bounce; // history in the high half
};

// What a path leaves for others: reuse.glsl. Points moved off their surfaces, to the side that they are seen from; normals
// of 0 where there is no such vertex.
struct FirstVertex {
  Vec3 o;
  Vec3 n;      // shading normal, as long as the path's probability to go on
  Vec3 ng;
  Vec3 weight; // reflectance over that probability, times the sample's weight in its pixel
};
struct SecondVertex {
  Vec3 end;
  uint triangle;
  Vec3 ng;
  uint pixel; // whose path it is
};
struct SharedLight {
  Vec3 L;      // that a second vertex sends on
  Float pdf_A; // of it, by all paths that share it together
};
