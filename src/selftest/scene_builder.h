#pragma once
// Scenes made in code: quads, boxes and triangles with materials, in world coordinates.

#include "scene/scene.h"

#include <initializer_list>

namespace vkpt::selftest {

/// Fov horizontal, in degrees.
Camera lookAt(const Vec3d& eye, const Vec3d& target, double fovDegrees, const Vec3d& up = {0.0, 1.0, 0.0});

/// A field of view so small that an image shows one point.
inline constexpr double kPointFov = 1e-3;

Material diffuse(const Vec3f& albedo, const Vec3f& emission = Vec3f(0.0F));
Material emitter(const Vec3f& emission);
Material mirror(const Vec3f& reflectance);
Material glass(float ior);
Material metal(const Vec3f& eta, const Vec3f& k);
Material phong(const Vec3f& kd, const Vec3f& ks, float exponent);
/// Nori's: kd below a coat of roughness alpha, ks = 1 - max(kd).
Material microfacet(const Vec3f& kd, float alpha, float ior);
Material roughMetal(const Vec3f& eta, const Vec3f& k, float alpha,
                    MicrofacetDistribution distribution = MicrofacetDistribution::Ggx);
Material roughGlass(float ior, float alpha,
                    MicrofacetDistribution distribution = MicrofacetDistribution::Ggx);

enum class Facing { Inward, Outward };

class SceneBuilder {
public:
  /// Corners counterclockwise as seen from the front.
  SceneBuilder& triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Material& material);
  /// Two triangles, (a, b, c) and (a, c, d).
  SceneBuilder& quad(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                     const Material& material);
  /// A horizontal square about `centre`, its front up or down.
  SceneBuilder& floor(const Vec3d& centre, double halfEdge, const Material& material);
  SceneBuilder& ceiling(const Vec3d& centre, double halfEdge, const Material& material);
  SceneBuilder& box(const Vec3d& lower, const Vec3d& upper, Facing facing, const Material& material);

  SceneBuilder& camera(const Camera& camera);
  SceneBuilder& background(const Vec3f& radiance);

  /// The scene scaled about the origin, then moved; recentred as the loader does it.
  [[nodiscard]] Scene build(double scale = 1.0, const Vec3d& offset = Vec3d(0.0)) const;

private:
  std::uint32_t materialIndex(const Material& material);

  std::vector<Vec3d> m_positions;
  Scene m_scene;
};

/// A box of albedo `albedo` about the camera whose walls all emit `emission`: radiance emission / (1 -
/// albedo) everywhere, whatever the camera sees.
Scene furnace(const Vec3f& albedo, const Vec3f& emission = Vec3f(1.0F));

/// Irradiance (W m^-2) of a diffuse polygon of radiance 1, all above the horizon, at `p` with unit normal
/// `n`: Lambert 1760, half the sum over the edges of the angle they subtend times the cosine of their plane.
double polygonIrradiance(std::initializer_list<Vec3d> polygon, const Vec3d& p, const Vec3d& n);

/// Fresnel's equations in double, for comparison: unpolarised reflectances at the cosine cosI.
double exactFresnelDielectric(double cosI, double eta);
double exactFresnelConductor(double cosI, double eta, double k);

} // namespace vkpt::selftest
