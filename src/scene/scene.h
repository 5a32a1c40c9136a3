#pragma once
// A scene as plain data: what the loaders make and everything else reads. Immutable once loaded.

#include "core/error.h"
#include "core/math.h"
#include "shared/structs.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vkpt {

/// How a surface scatters: Diffuse, Phong, ...
///
/// Phong: diffuse and a lobe about the mirror direction, energy not conserved (Nori's course). Microfacet:
/// diffuse under a rough dielectric coat, Nori's `microfacet`. RoughConductor, RoughDielectric: metal and
/// glass of microfacets.
enum class BsdfType : std::uint32_t {
#define VKPT_ENUMERATOR(Name, Type) Type = shared::kBsdf##Type,
  VKPT_BSDFS(VKPT_ENUMERATOR)
#undef VKPT_ENUMERATOR
};

enum class MicrofacetDistribution : std::uint32_t { Ggx = 0, Beckmann = 1 };

inline constexpr std::uint32_t kNoTexture = 0xFFFFFFFFU;

struct Material {
  std::string name;
  SourceLocation where;
  BsdfType bsdf = BsdfType::Diffuse;
  Vec3f reflectance{0.5F}; ///< Diffuse: albedo; Mirror: reflectance; Phong, Microfacet: kd. Linear RGB.
  std::uint32_t texture = kNoTexture; ///< index into Scene::textures; multiplies `reflectance`
  Vec3f specular{0.0F};               ///< Phong: ks. Microfacet: ks, 1 - max(kd) in all channels.
  float exponent = 20.0F;             ///< Phong: n, 0 to 1e6
  float roughness = 0.1F;             ///< Microfacet, RoughConductor, RoughDielectric: alpha
  MicrofacetDistribution distribution = MicrofacetDistribution::Ggx;
  bool twoSided = true;   ///< opaque materials: the back scatters as the front does; false: it is black
  Vec3f emission{0.0F};   ///< Radiance of the front side, W m^-2 sr^-1.
  float intIor = 1.5F;    ///< Dielectric: index behind the surface (opposite to the normal).
  float extIor = 1.0F;    ///< Dielectric: index in front of the surface.
  Vec3f eta{1.0F};        ///< Conductor: real part of the index of refraction, per channel.
  Vec3f k{0.0F};          ///< Conductor: imaginary part.
  Vec3f absorption{0.0F}; ///< Dielectric: behind the surface, per unit of the scene's length (Beer-Lambert)
};

/// Linear RGB, row 0 at the top, repeated in both directions; v runs upwards from the bottom row.
struct Texture {
  std::string name;
  SourceLocation where;
  int width = 0;
  int height = 0;
  std::vector<Vec3f> texels;
};

inline constexpr std::uint32_t kNoNormal = 0xFFFFFFFFU;
inline constexpr std::uint32_t kNoUv = 0xFFFFFFFFU;

/// Counterclockwise seen from the front. Indices into Scene::positions, Scene::normals and Scene::uvs.
struct Triangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<std::uint32_t, 3> normal{kNoNormal, kNoNormal, kNoNormal}; ///< all three or none
  std::uint32_t material = 0;
  std::array<std::uint32_t, 3> uv{kNoUv, kNoUv, kNoUv}; ///< all three or none
};

struct PointLight {
  SourceLocation where;
  Vec3f position{0.0F};  ///< relative to Scene::origin
  Vec3f intensity{0.0F}; ///< W/sr
};

struct DirectionalLight {
  SourceLocation where;
  Vec3f direction{0.0F, -1.0F, 0.0F}; ///< in which the light travels, unit length
  Vec3f irradiance{0.0F};             ///< of a surface that faces it, W/m^2
};

/// Radiance that arrives from infinity, constant over each texel. Latitude and longitude: row 0 about +y;
/// direction (sin(theta) sin(phi), cos(theta), -sin(theta) cos(phi)), phi = 2 pi (column / width - 1/2), so
/// that the middle column lies in -z.
struct EnvironmentMap {
  SourceLocation where;
  fs::path file; ///< .hdr or .exr, whose pixels `radiance` is to hold; empty: there is none
  int width = 0; ///< 0: there is none
  int height = 0;
  std::vector<Vec3f> radiance; ///< rows from the top
};

/// How a pixel's samples are weighted by their distance to its centre, per axis, in pixels.
struct PixelFilter {
  enum class Shape : std::uint32_t { Box = 0, Tent = 1, Gaussian = 2, Mitchell = 3 };
  Shape shape = Shape::Box;
  double radius = 0.5;  ///< outside it the weight is 0
  double stddev = 0.5;  ///< Gaussian: exp(-x^2 / (2 stddev^2)) less its value at `radius`
  double b = 1.0 / 3.0; ///< Mitchell
  double c = 1.0 / 3.0;
};

/// How emitters are found.
enum class LightStrategy : std::uint32_t {
  Nee = 0,  ///< next event estimation: by sampling points on emitters
  Bsdf = 1, ///< by directions sampled from the BSDF alone
  Mis = 2,  ///< both, weighted: multiple importance sampling
};

/// The kinds of light path, from the eye; S specular, D any other scattering. They part all paths.
enum class PathKind : std::uint32_t {
  Emission = 0,        ///< E L
  Direct = 1,          ///< E S* D L
  Caustic = 2,         ///< E S* D (Sr | St St) L
  Indirect = 3,        ///< E S* D D+ L
  IndirectCaustic = 4, ///< every other path with an S behind the first D
  Specular = 5,        ///< E S+ L
};
inline constexpr std::uint32_t kPathKindCount = 6;

/// What a scene file says about the estimator; options come before it.
struct EstimatorDefaults {
  std::optional<LightStrategy> light;
  std::optional<std::uint32_t> maxBounces;
  std::optional<std::uint32_t> pathKinds; ///< bit i: PathKind i is rendered
};

/// A perspective camera in world coordinates (before recentring).
struct Camera {
  enum class FovAxis { Horizontal, Vertical };
  Vec3d eye{0.0};
  Vec3d target{0.0, 0.0, -1.0};
  Vec3d up{0.0, 1.0, 0.0};
  double fovDegrees = 45.0; ///< the full angle along `fovAxis`
  FovAxis fovAxis = FovAxis::Horizontal;
  bool mirrored = false; ///< the image is that of a mirror: left and right change places
};

struct Scene {
  std::string name;             ///< for metadata and default file names, e.g. "CornellBox+CornellBlocks"
  Vec3d origin{0.0};            ///< world position of the local coordinates' origin (recentred in double)
  std::vector<Vec3f> positions; ///< relative to `origin`
  std::vector<Vec3f> normals;   ///< unit length
  std::vector<Vec2f> uvs;
  std::vector<Triangle> triangles;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<PointLight> pointLights;
  std::vector<DirectionalLight> directionalLights;
  EnvironmentMap environment;
  Camera camera;
  PixelFilter filter;
  EstimatorDefaults defaults;
  Vec3f background{0.0F}; ///< radiance of rays that leave the scene, beside the environment's
  int width = 512;
  int height = 512;
  int defaultFrames = 64;
};

/// What a loader tells the user: conventions applied, and what was odd.
struct SceneReport {
  std::vector<std::string> notes;    ///< "Cornell rule: x0.025, turned, camera fitted"
  std::vector<std::string> warnings; ///< each names file:line and what was done about it
  std::size_t droppedDegenerate = 0; ///< triangles of zero area
  std::size_t inventedNormals = 0;   ///< vertices given a smooth normal
};

} // namespace vkpt
