// The whole library in the order it needs. The including program defines the accessors between records.glsl and
// this file.
#include "rng.glsl"
#include "sampler.glsl"
#include "frame.glsl"
#include "ray.glsl"
#include "triangle.glsl"
#ifdef VKPT_FOREIGN_TRAVERSAL // a host program with another traversal: tests/bench/yardstick.cpp
#include VKPT_FOREIGN_TRAVERSAL
#else
#include "stack.glsl"
#include "traverse.glsl"
#endif
#include "bsdf.glsl"
#include "bsdf_diffuse.glsl"
#include "bsdf_mirror.glsl"
#include "bsdf_conductor.glsl"
#include "bsdf_dielectric.glsl"
#include "bsdf_phong.glsl"
#include "microfacet.glsl"
#include "bsdf_microfacet.glsl"
#include "bsdf_roughconductor.glsl"
#include "bsdf_roughdielectric.glsl"
#include "texture.glsl"
#include "surface.glsl"
#include "scatter.glsl"
#include "environment.glsl"
#include "light.glsl"
#include "kinds.glsl"
#include "path.glsl"
#include "filter.glsl"
#include "camera.glsl"
#include "film.glsl"
