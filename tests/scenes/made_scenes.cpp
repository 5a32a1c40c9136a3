#include "scenes/made_scenes.h"

namespace vkpt::test {

EstimatorSettings findingLightBy(LightStrategy light) {
  EstimatorSettings s;
  s.light = light;
  return s;
}

void addPointLight(Scene& scene, const Vec3d& position, const Vec3f& intensity) {
  scene.pointLights.push_back({{}, Vec3f(position - scene.origin), intensity});
}

void addDirectionalLight(Scene& scene, const Vec3d& direction, const Vec3f& irradiance) {
  scene.directionalLights.push_back({{}, Vec3f(glm::normalize(direction)), irradiance});
}

EnvironmentMap environmentMap(int width, int height,
                              const std::function<Vec3f(int column, int row)>& radiance) {
  EnvironmentMap map;
  map.width = width;
  map.height = height;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column)
      map.radiance.push_back(radiance(column, row));
  }
  return map;
}

Texture textureOf(int width, int height, const std::vector<Vec3f>& texels) {
  Texture t;
  t.width = width;
  t.height = height;
  t.texels = texels;
  return t;
}

void textureLastQuad(Scene& scene, const Texture& texture, const std::array<Vec2f, 4>& uv) {
  const auto first = static_cast<std::uint32_t>(scene.uvs.size());
  scene.uvs.insert(scene.uvs.end(), uv.begin(), uv.end());
  const auto index = static_cast<std::uint32_t>(scene.textures.size());
  scene.textures.push_back(texture);
  const std::size_t last = scene.triangles.size() - 1;
  scene.triangles[last - 1].uv = {first, first + 1, first + 2}; // SceneBuilder::quad()
  scene.triangles[last].uv = {first, first + 2, first + 3};
  for (const std::size_t t : {last - 1, last})
    scene.materials[scene.triangles[t].material].texture = index;
}

Scene variety() {
  Material tinted = glass(1.4F);
  tinted.absorption = {0.2F, 1.0F, 2.0F};
  Material backless = diffuse({0.3F, 0.7F, 0.4F});
  backless.twoSided = false;
  Scene scene =
      SceneBuilder()
          .box({-0.9, 0.05, -0.5}, {-0.2, 0.6, 0.2}, Facing::Outward, tinted)
          .box({0.0, 0.0, -0.9}, {0.4, 0.5, -0.5}, Facing::Outward, phong(Vec3f(0.3F), Vec3f(0.5F), 40.0F))
          .quad({-1.4, 0.0, -1.2}, {0.2, 0.0, -1.4}, {0.2, 1.4, -1.4}, {-1.4, 1.4, -1.2},
                mirror({0.9F, 0.8F, 0.7F}))
          .quad({0.4, 0.0, -1.2}, {1.2, 0.0, -0.6}, {1.2, 0.9, -0.6}, {0.4, 0.9, -1.2},
                metal({0.2F, 0.9F, 1.1F}, {3.9F, 2.5F, 2.2F}))
          .quad({0.5, 0.0, 0.3}, {1.0, 0.0, 0.1}, {1.0, 0.5, 0.1}, {0.5, 0.5, 0.3}, backless)
          .ceiling({0.3, 1.5, 0.2}, 0.3, emitter({3.0F, 2.5F, 2.0F}))
          .floor({0.0, 0.0, 0.0}, 1.5, diffuse({0.8F, 0.7F, 0.6F}))
          .camera(lookAt({0.2, 1.3, 2.6}, {0.0, 0.3, -0.2}, 48.0))
          .build();
  textureLastQuad(scene, textureOf(2, 2, {{1.0F, 0.5F, 0.5F}, Vec3f(0.3F), Vec3f(0.4F), {0.5F, 0.6F, 1.0F}}),
                  {Vec2f(0.0F), {3.0F, 0.0F}, {3.0F, 3.0F}, {0.0F, 3.0F}});
  addPointLight(scene, {-1.2, 1.2, 1.0}, {0.5F, 0.6F, 0.9F});
  addDirectionalLight(scene, {-0.3, -1.0, -0.6}, {0.4F, 0.4F, 0.3F});
  scene.environment = environmentMap(8, 4, [](int column, int row) {
    return row == 1 && column == 5 ? Vec3f(2.0F, 1.6F, 1.0F)
                                   : Vec3f(0.1F, 0.2F, 0.3F + 0.05F * static_cast<float>(row));
  });
  return scene;
}

namespace {

/// A quad as SceneBuilder makes it, in a scene that is built.
void addQuad(Scene& scene, const std::array<Vec3d, 4>& corners, const Material& material) {
  const auto first = static_cast<std::uint32_t>(scene.positions.size());
  for (const Vec3d& corner : corners)
    scene.positions.emplace_back(corner - scene.origin);
  const auto index = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back(material);
  for (const std::uint32_t i : {1U, 2U}) {
    Triangle& t = scene.triangles.emplace_back();
    t.vertex = {first, first + i, first + i + 1};
    t.material = index;
  }
}

} // namespace

Scene everything() {
  Scene scene = variety();
  const auto upright = [&scene](double x, const Material& material) {
    addQuad(scene, {Vec3d(x, 0.0, 0.6), {x + 0.4, 0.0, 0.6}, {x + 0.4, 0.3, 0.6}, {x, 0.3, 0.6}}, material);
  };
  upright(-1.2, roughMetal(Vec3f(0.2F), Vec3f(3.0F), 0.3F));
  upright(-0.7, roughGlass(1.5F, 0.2F, MicrofacetDistribution::Beckmann));
  upright(-0.2, microfacet({0.3F, 0.2F, 0.1F}, 0.2F, 1.5F));
  const auto normal = static_cast<std::uint32_t>(scene.normals.size());
  for (const float tilt : {-0.2F, 0.0F, 0.2F})
    scene.normals.push_back(glm::normalize(Vec3f(tilt, 0.0F, 1.0F)));
  scene.triangles.back().normal = {normal, normal + 1, normal + 2};
  addQuad(scene, {Vec3d(0.1, 0.5, 0.6), {0.3, 0.5, 0.6}, {0.3, 0.7, 0.6}, {0.1, 0.7, 0.6}}, glass(1.5F));
  scene.background = Vec3f(0.1F);
  scene.filter.shape = PixelFilter::Shape::Tent;
  scene.filter.radius = 1.0;
  return scene;
}

EstimatorSettings everyOption() {
  EstimatorSettings settings = misSampling();
  settings.lightSamples = 2;
  settings.splitDepth = 3;
  settings.maxBounces = 8;
  settings.pathKinds = kAllPathKinds & ~1U;
  settings.kindImages = true;
  settings.specularSamples = 2;
  settings.lightSelection = LightSelection::Tree;
  return settings;
}

} // namespace vkpt::test
