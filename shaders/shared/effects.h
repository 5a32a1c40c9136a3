// Every effect a scene can call for, one line each: X(id, Name, name, what must be true of the scene and the
// options). From this list come the C++ enum, the names, the specialisation constants and their map, and the
// tables. Ids are positions in a bit set and specialisation constant ids; never reuse one.
#ifndef VKPT_SHARED_EFFECTS_H
#define VKPT_SHARED_EFFECTS_H

#define VKPT_EFFECTS(X)                                                                                      \
  X(0, Diffuse, diffuse, "a triangle whose material scatters diffusely")                                     \
  X(1, Mirror, mirror, "a triangle with a mirror material")                                                  \
  X(2, Glass, glass, "a triangle with a smooth dielectric material")                                         \
  X(3, Metal, metal, "a triangle with a smooth conductor material")                                          \
  X(4, SmoothNormals, smoothNormals, "a triangle with shading normals of its own")                           \
  X(5, AreaLights, areaLights, "a triangle of positive area whose material emits")                           \
  X(6, ManyLights, manyLights, "more than one light to sample: a table to choose from")                      \
  X(7, LightSampling, lightSampling, "lights to sample, by --light nee or mis or as they can't be hit")      \
  X(8, Background, background, "a constant background radiance above zero, and a way out to it")             \
  X(9, BounceLimit, bounceLimit, "--max-bounces below infinity")                                             \
  X(10, Roulette, roulette, "a surface after which a path can go on without limit")                          \
  X(11, Mis, mis, "lights that light sampling and BSDF sampling both find, and --light mis")                 \
  X(12, Phong, phong, "a triangle with a Phong material whose ks is above zero")                             \
  X(13, Microfacet, microfacet, "a triangle with Nori's microfacet material")                                \
  X(14, RoughMetal, roughMetal, "a triangle with a rough conductor material")                                \
  X(15, RoughGlass, roughGlass, "a triangle with a rough dielectric material")                               \
  X(16, Textures, textures, "a triangle whose material has a texture of more than one colour")               \
  X(17, Absorption, absorption, "a triangle with a dielectric material that absorbs")                        \
  X(18, DeltaLights, deltaLights, "a point light, or a directional light and a way out to it")               \
  X(19, Environment, environment, "an environment map that is not black, and a way out to it")               \
  X(20, OneSided, oneSided, "a triangle whose material scatters on one side only")                           \
  X(21, LightSamples, lightSamples, "--light-samples above 1")                                               \
  X(22, Splitting, splitting, "a smooth dielectric, mirror or conductor, and --split above 0")               \
  X(23, PathKinds, pathKinds, "--paths with fewer than all kinds, or --output-paths")                        \
  X(24, KindImages, kindImages, "--output-paths")                                                            \
  X(25, PixelFilter, pixelFilter, "a reconstruction filter other than a box of one pixel")                   \
  X(26, Ggx, ggx, "rough metal or rough glass with the distribution ggx")                                    \
  X(27, Beckmann, beckmann, "rough metal or rough glass with the distribution beckmann")                     \
  X(28, LightTracing, lightTracing,                                                                          \
    "area lights, specular and other surfaces, and --light-tracing auto or on")                              \
  X(29, SpecularSamples, specularSamples, "a specular surface, and --specular-samples above 1")              \
  X(30, LightTree, lightTree, "several lights, spread out, or --light-selection tree: chosen by place")      \
  X(31, PathReuse, pathReuse, "a diffuse surface, --path-reuse above 1, and paths that go on beyond it")     \
  X(32, Guiding, guiding, "light tracing, a diffuse surface, and --guiding auto")

// How surfaces scatter: X(Name of the effect, Type). A type's number is its effect's id; sampleTYPE() and,
// unless it is specular, evaluateTYPE() are chosen by it (shaders/lib/scatter.glsl). What is not diffuse:
#define VKPT_GLOSSY_BSDFS(X)                                                                                 \
  X(Phong, Phong)                                                                                            \
  X(Microfacet, Microfacet)                                                                                  \
  X(RoughMetal, RoughConductor)                                                                              \
  X(RoughGlass, RoughDielectric)
// Delta distributions: light sampling can't find what they scatter.
#define VKPT_SPECULAR_BSDFS(X)                                                                               \
  X(Mirror, Mirror)                                                                                          \
  X(Glass, Dielectric)                                                                                       \
  X(Metal, Conductor)
#define VKPT_SMOOTH_BSDFS(X) X(Diffuse, Diffuse) VKPT_GLOSSY_BSDFS(X)
#define VKPT_BSDFS(X) VKPT_SMOOTH_BSDFS(X) VKPT_SPECULAR_BSDFS(X)

#endif
