// Every effect a scene can call for, one line each: X(id, name, what must be true of the scene and the
// options). From this list come the C++ enum, the names, the specialisation constants and their map, and the
// tables. Ids are positions in a bit set and specialisation constant ids; never reuse one.
#define VKPT_EFFECTS(X)                                                                                      \
  X(0, Diffuse, diffuse, "a triangle whose material scatters diffusely")                                     \
  X(1, Mirror, mirror, "a triangle with a mirror material")                                                  \
  X(2, Glass, glass, "a triangle with a dielectric material whose indices differ")                           \
  X(3, Metal, metal, "a triangle with a conductor material")                                                 \
  X(4, SmoothNormals, smoothNormals, "a triangle with shading normals of its own")                           \
  X(5, AreaLights, areaLights, "a triangle of positive area whose material emits")                           \
  X(6, ManyLights, manyLights, "more than one emissive triangle: a table to choose from")                    \
  X(7, LightSampling, lightSampling, "area lights, and --light nee")                                         \
  X(8, Background, background, "a background radiance above zero")                                           \
  X(9, BounceLimit, bounceLimit, "--max-bounces below infinity")                                             \
  X(10, Roulette, roulette, "a surface after which a path can go on without limit")
