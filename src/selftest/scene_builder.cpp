#include "selftest/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace vkpt::selftest {

Camera lookAt(const Vec3d& eye, const Vec3d& target, double fovDegrees, const Vec3d& up) {
  return {eye, target, up, fovDegrees, Camera::FovAxis::Horizontal};
}

Material diffuse(const Vec3f& albedo, const Vec3f& emission) {
  Material m;
  m.reflectance = albedo;
  m.emission = emission;
  return m;
}

Material emitter(const Vec3f& emission) { return diffuse(Vec3f(0.0F), emission); }

Material mirror(const Vec3f& reflectance) {
  Material m;
  m.bsdf = BsdfType::Mirror;
  m.reflectance = reflectance;
  return m;
}

Material glass(float ior) {
  Material m;
  m.bsdf = BsdfType::Dielectric;
  m.intIor = ior;
  return m;
}

Material metal(const Vec3f& eta, const Vec3f& k) {
  Material m;
  m.bsdf = BsdfType::Conductor;
  m.eta = eta;
  m.k = k;
  return m;
}

Material phong(const Vec3f& kd, const Vec3f& ks, float exponent) {
  Material m;
  m.bsdf = BsdfType::Phong;
  m.reflectance = kd;
  m.specular = ks;
  m.exponent = exponent;
  return m;
}

Material microfacet(const Vec3f& kd, float alpha, float ior) {
  Material m;
  m.bsdf = BsdfType::Microfacet;
  m.reflectance = kd;
  m.specular = Vec3f(1.0F - std::max({kd.x, kd.y, kd.z}));
  m.roughness = alpha;
  m.distribution = MicrofacetDistribution::Beckmann;
  m.intIor = ior;
  return m;
}

Material roughMetal(const Vec3f& eta, const Vec3f& k, float alpha, MicrofacetDistribution distribution) {
  Material m = metal(eta, k);
  m.bsdf = BsdfType::RoughConductor;
  m.roughness = alpha;
  m.distribution = distribution;
  return m;
}

Material roughGlass(float ior, float alpha, MicrofacetDistribution distribution) {
  Material m = glass(ior);
  m.bsdf = BsdfType::RoughDielectric;
  m.roughness = alpha;
  m.distribution = distribution;
  return m;
}

std::uint32_t SceneBuilder::materialIndex(const Material& material) {
  m_scene.materials.push_back(material);
  return static_cast<std::uint32_t>(m_scene.materials.size() - 1);
}

SceneBuilder& SceneBuilder::triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c,
                                     const Material& material) {
  const auto first = static_cast<std::uint32_t>(m_positions.size());
  m_positions.insert(m_positions.end(), {a, b, c});
  Triangle t{{first, first + 1, first + 2}};
  t.material = materialIndex(material);
  m_scene.triangles.push_back(t);
  return *this;
}

SceneBuilder& SceneBuilder::quad(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
                                 const Material& material) {
  return triangle(a, b, c, material).triangle(a, c, d, material);
}

SceneBuilder& SceneBuilder::floor(const Vec3d& centre, double h, const Material& material) {
  return quad(centre + Vec3d(-h, 0, h), centre + Vec3d(h, 0, h), centre + Vec3d(h, 0, -h),
              centre + Vec3d(-h, 0, -h), material);
}

SceneBuilder& SceneBuilder::ceiling(const Vec3d& centre, double h, const Material& material) {
  return quad(centre + Vec3d(-h, 0, -h), centre + Vec3d(h, 0, -h), centre + Vec3d(h, 0, h),
              centre + Vec3d(-h, 0, h), material);
}

SceneBuilder& SceneBuilder::box(const Vec3d& lower, const Vec3d& upper, Facing facing,
                                const Material& material) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const auto corner = [&](bool atU, bool atV) {
        Vec3d p;
        p[axis] = (high ? upper : lower)[axis];
        p[u] = (atU ? upper : lower)[u];
        p[v] = (atV ? upper : lower)[v];
        return p;
      };
      // u x v = axis, so (u, v) in order faces along +axis.
      if (high == (facing == Facing::Outward))
        quad(corner(false, false), corner(true, false), corner(true, true), corner(false, true), material);
      else
        quad(corner(false, false), corner(false, true), corner(true, true), corner(true, false), material);
    }
  }
  return *this;
}

SceneBuilder& SceneBuilder::camera(const Camera& camera) {
  m_scene.camera = camera;
  return *this;
}

SceneBuilder& SceneBuilder::background(const Vec3f& radiance) {
  m_scene.background = radiance;
  return *this;
}

Scene SceneBuilder::build(double scale, const Vec3d& offset) const {
  Scene scene = m_scene;
  const auto place = [&](const Vec3d& p) { return p * scale + offset; };
  Box3d bounds;
  for (const Vec3d& p : m_positions)
    bounds.extend(place(p));
  scene.origin = bounds.centre();
  for (const Vec3d& p : m_positions)
    scene.positions.emplace_back(place(p) - scene.origin);
  scene.camera.eye = place(scene.camera.eye);
  scene.camera.target = place(scene.camera.target);
  return scene;
}

Scene furnace(const Vec3f& albedo, const Vec3f& emission) {
  return SceneBuilder()
      .box({-1.0, -1.2, -0.9}, {1.1, 1.0, 1.3}, Facing::Inward, diffuse(albedo, emission))
      .camera(lookAt({0.1, -0.2, 0.3}, {1.0, 0.5, -0.3}, 90.0))
      .build();
}

double polygonIrradiance(std::initializer_list<Vec3d> polygon, const Vec3d& p, const Vec3d& n) {
  const std::vector<Vec3d> corners(polygon);
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = glm::normalize(corners[i] - p);
    const Vec3d b = glm::normalize(corners[(i + 1) % corners.size()] - p);
    sum += std::acos(glm::dot(a, b)) * glm::dot(glm::normalize(glm::cross(a, b)), n);
  }
  return 0.5 * std::abs(sum);
}

double exactFresnelDielectric(double cosI, double eta) { return exactFresnelConductor(cosI, eta, 0.0); }

double exactFresnelConductor(double cosI, double eta, double k) {
  using Complex = std::complex<double>;
  const Complex index(eta, k);
  const Complex cosT = std::sqrt(1.0 - (1.0 - cosI * cosI) / (index * index));
  const Complex rs = (cosI - index * cosT) / (cosI + index * cosT);
  const Complex rp = (index * cosI - cosT) / (index * cosI + cosT);
  return 0.5 * (std::norm(rs) + std::norm(rp));
}

} // namespace vkpt::selftest
