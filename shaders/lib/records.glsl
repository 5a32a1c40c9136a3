// What the accessors return. Each program reads its own memory: texel buffers on the device (device_memory.glsl),
// arrays on the host (src/host/program.h).

struct TriangleRecord {
  Vec3 v0;
  Vec3 v1;
  Vec3 v2;
  uint material;
  uint id; // in input order
};

// A light, and the row of the alias table with the same index.
struct LightRecord {
  Vec3 v0;
  Vec3 v1;
  Vec3 v2;
  Vec3 radiance;
  Float probability; // with which the light is chosen
  uint triangle;     // in BVH order
  Float threshold;   // the row keeps itself when the second number is below
  uint alias;
};

struct Material {
  uint bsdf;
  Vec3 reflectance; // diffuse: albedo; mirror: reflectance
  Vec3 emission;    // radiance of the front side
  Float ior;        // dielectric: index behind the surface over the index in front of it
  Vec3 eta;         // conductor: complex index of refraction
  Vec3 k;
};
