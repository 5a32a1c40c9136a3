// Effects by effective value: each rule with its near miss.
#include "core/error.h"
#include "device/camera_frame.h"
#include "device/effective_material.h"
#include "device/effects.h"
#include "device/light_tracing.h"
#include "device/packed_scene.h"
#include "scenes/made_scenes.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

const Vec3f kLamp(3.0F);

/// A diffuse floor, a lamp over it and what the test adds.
SceneBuilder room() {
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F)))
      .ceiling({0.0, 2.0, 0.0}, 0.5, emitter(kLamp))
      .camera(lookAt({0.0, 1.0, 3.0}, Vec3d(0.0), 60.0));
  return builder;
}

Scene roomWith(const Material& material) {
  return room().quad({-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1}, material).build();
}

EffectSet effectsIn(const Scene& scene) { return detectEffects(scene, misSampling()); }

EffectReason reasonFor(const Scene& scene, Effect effect) {
  return explainEffects(scene, misSampling()).of(effect);
}

Scene lampOf(const Vec3f& radiance, double size) {
  return SceneBuilder()
      .floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F)))
      .triangle({0, 2, 0}, {size, 2, 0}, {0, 2, size}, emitter(radiance))
      .camera(lookAt({0.0, 1.0, 3.0}, Vec3d(0.0), 60.0))
      .build();
}

TEST(Effects, AnEmitterOfRadianceZeroIsNone) {
  EXPECT_TRUE(effectsIn(lampOf({0.0F, 0.0F, 1e-6F}, 1.0)).has(Effect::AreaLights));
  const EffectSet dark = effectsIn(lampOf(Vec3f(0.0F), 1.0));
  EXPECT_FALSE(dark.has(Effect::AreaLights));
  EXPECT_FALSE(dark.has(Effect::LightSampling));
  EXPECT_FALSE(dark.has(Effect::Mis));
}

TEST(Effects, AnEmitterOfAreaZeroIsNone) {
  EXPECT_TRUE(effectsIn(lampOf(kLamp, 1e-6)).has(Effect::AreaLights));
  const Scene flat = lampOf(kLamp, 0.0);
  EXPECT_FALSE(effectsIn(flat).has(Effect::AreaLights));
  EXPECT_FALSE(effectsIn(flat).has(Effect::LightSampling));
  EXPECT_NE(reasonFor(flat, Effect::AreaLights).because.find("from no triangle"), std::string::npos);
}

TEST(Effects, AMaterialWithoutATriangleIsNone) {
  for (const Material& m : {mirror(Vec3f(1.0F)), glass(1.5F), metal(Vec3f(0.2F), Vec3f(3.0F)),
                            phong(Vec3f(0.2F), Vec3f(0.5F), 20.0F)}) {
    Scene scene = roomWith(m);
    const EffectSet with = effectsIn(scene);
    scene.triangles.resize(scene.triangles.size() - 2);
    const EffectSet without = effectsIn(scene);
    EXPECT_EQ(without, effectsIn(room().build()));
    EXPECT_NE(with, without);
  }
}

TEST(Effects, AMaterialOnATriangleWithoutAreaIsNone) {
  const Scene scene = room().triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, mirror(Vec3f(1.0F))).build();
  EXPECT_EQ(effectsIn(scene), effectsIn(room().build()));
}

TEST(Effects, PhongWithoutALobeIsDiffuse) {
  EXPECT_TRUE(effectsIn(roomWith(phong(Vec3f(0.2F), {0.0F, 0.01F, 0.0F}, 20.0F))).has(Effect::Phong));
  EXPECT_EQ(effectsIn(roomWith(phong(Vec3f(0.2F), Vec3f(0.0F), 20.0F))), effectsIn(room().build()));
}

TEST(Effects, ABlackMirrorIsABlackSurface) {
  EXPECT_TRUE(effectsIn(roomWith(mirror({0.0F, 0.0F, 0.01F}))).has(Effect::Mirror));
  EXPECT_EQ(effectsIn(roomWith(mirror(Vec3f(0.0F)))), effectsIn(room().build()));
}

TEST(Effects, RoughMetalAsSmoothAsCanBeIsMetal) {
  const Vec3f eta(0.2F);
  const Vec3f k(3.0F);
  EXPECT_TRUE(effectsIn(roomWith(roughMetal(eta, k, 0.1F))).has(Effect::RoughMetal));
  EXPECT_EQ(effectsIn(roomWith(roughMetal(eta, k, 0.0F))), effectsIn(roomWith(metal(eta, k))));
}

TEST(Effects, GlassOfIndexOneIsNothing) {
  EXPECT_TRUE(effectsIn(roomWith(glass(1.0001F))).has(Effect::Glass));
  for (Material m : {glass(1.0F), roughGlass(1.0F, 0.3F)}) {
    EXPECT_EQ(effectsIn(roomWith(m)), effectsIn(room().build()));
    m.intIor = m.extIor = 1.33F; // in water: the ratio decides
    EXPECT_EQ(effectsIn(roomWith(m)), effectsIn(room().build()));
  }
}

TEST(Effects, GlassOfIndexOneThatAbsorbsOrEmitsIsSomething) {
  Material tinted = glass(1.0F);
  tinted.absorption = {0.0F, 0.0F, 0.1F};
  const EffectSet absorbs = effectsIn(roomWith(tinted));
  EXPECT_TRUE(absorbs.has(Effect::Glass));
  EXPECT_TRUE(absorbs.has(Effect::Absorption));
  Material glowing = glass(1.0F);
  glowing.emission = Vec3f(1.0F);
  EXPECT_TRUE(effectsIn(roomWith(glowing)).has(Effect::Glass));
  EXPECT_FALSE(effectsIn(roomWith(glass(1.5F))).has(Effect::Absorption));
}

/// The room's last quad with this normal at its corners; its own is (0, 0, 1).
Scene shadedWith(const std::array<Vec3f, 3>& normals, const Material& material = diffuse(Vec3f(0.3F))) {
  Scene scene = roomWith(material);
  scene.normals.assign(normals.begin(), normals.end());
  for (std::size_t i = scene.triangles.size() - 2; i < scene.triangles.size(); ++i)
    scene.triangles[i].normal = {0, 1, 2};
  return scene;
}

TEST(Effects, NormalsThatAreTheTrianglesOwnAreNone) {
  const Vec3f own(0.0F, 0.0F, 1.0F);
  const Vec3f back = -own;
  const auto tilted = [](float angle) { return Vec3f(std::sin(angle), 0.0F, std::cos(angle)); };
  EXPECT_FALSE(effectsIn(shadedWith({own, own, own})).has(Effect::SmoothNormals));
  EXPECT_FALSE(effectsIn(shadedWith({back, back, back})).has(Effect::SmoothNormals)) << "turned about";
  EXPECT_FALSE(effectsIn(shadedWith({own, tilted(5e-6F), own})).has(Effect::SmoothNormals)) << "rounded";
  EXPECT_TRUE(effectsIn(shadedWith({own, own, tilted(1e-3F)})).has(Effect::SmoothNormals));
  EXPECT_TRUE(effectsIn(shadedWith({own, back, own})).has(Effect::SmoothNormals)) << "not of one side";
}

TEST(Effects, NormalsOfWhatDoesNotScatterAreNone) {
  const std::array<Vec3f, 3> bent{Vec3f(0.6F, 0.0F, 0.8F), Vec3f(0.0F, 0.6F, 0.8F), Vec3f(0.0F, 0.0F, 1.0F)};
  EXPECT_TRUE(effectsIn(shadedWith(bent)).has(Effect::SmoothNormals));
  EXPECT_FALSE(effectsIn(shadedWith(bent, emitter(kLamp))).has(Effect::SmoothNormals));
  EXPECT_FALSE(effectsIn(shadedWith(bent, glass(1.0F))).has(Effect::SmoothNormals));
}

Scene texturedRoom(const Material& material) {
  Scene scene = roomWith(material);
  textureLastQuad(scene, textureOf(2, 1, {Vec3f(0.2F), Vec3f(0.9F)}), {});
  return scene;
}

TEST(Effects, ATextureCountsWhereItTintsWhatIsScattered) {
  EXPECT_TRUE(effectsIn(texturedRoom(diffuse(Vec3f(0.5F)))).has(Effect::Textures));
  EXPECT_TRUE(effectsIn(texturedRoom(mirror(Vec3f(0.5F)))).has(Effect::Textures));
  EXPECT_FALSE(effectsIn(texturedRoom(glass(1.5F))).has(Effect::Textures));
  EXPECT_FALSE(effectsIn(texturedRoom(diffuse(Vec3f(0.0F)))).has(Effect::Textures));
  EXPECT_FALSE(effectsIn(texturedRoom(phong(Vec3f(0.0F), Vec3f(0.5F), 9.0F))).has(Effect::Textures));
}

TEST(Effects, ATextureOfOneColourIsThatColour) {
  const Vec3f colour(0.2F, 0.4F, 0.0F);
  const auto sceneWith = [](const std::vector<Vec3f>& texels, const Vec3f& kd) {
    Scene scene = roomWith(diffuse(kd));
    textureLastQuad(scene, textureOf(2, 2, texels), {});
    return scene;
  };
  const Scene plain = sceneWith({colour, colour, colour, colour}, Vec3f(0.5F));
  EXPECT_EQ(effectsIn(plain), effectsIn(room().build()));
  EXPECT_EQ(effectiveMaterials(plain).back().reflectance, 0.5F * colour);
  EXPECT_NE(reasonFor(plain, Effect::Textures).because.find("a texture of one colour"), std::string::npos);
  const Vec3f nearly = colour + Vec3f(0.0F, 0.0F, 1e-6F);
  EXPECT_TRUE(effectsIn(sceneWith({colour, colour, colour, nearly}, Vec3f(0.5F))).has(Effect::Textures));
  const std::vector<Vec3f> black(4, Vec3f(0.0F));
  Scene mirrored = roomWith(mirror(Vec3f(0.5F)));
  textureLastQuad(mirrored, textureOf(2, 2, black), {});
  EXPECT_EQ(effectsIn(mirrored), effectsIn(room().build())) << "a black mirror";
}

TEST(Effects, FacetsHaveTheDistributionsThatOccur) {
  const auto ggx = MicrofacetDistribution::Ggx;
  const auto beckmann = MicrofacetDistribution::Beckmann;
  const auto metalOf = [](MicrofacetDistribution d) { return roughMetal(Vec3f(0.2F), Vec3f(3.0F), 0.3F, d); };
  const auto both = [](const EffectSet& set) {
    return std::pair(set.has(Effect::Ggx), set.has(Effect::Beckmann));
  };
  EXPECT_EQ(both(effectsIn(roomWith(metalOf(ggx)))), std::pair(true, false));
  EXPECT_EQ(both(effectsIn(roomWith(metalOf(beckmann)))), std::pair(false, true));
  EXPECT_EQ(both(effectsIn(roomWith(roughGlass(1.5F, 0.3F, beckmann)))), std::pair(false, true));
  EXPECT_EQ(both(effectsIn(roomWith(microfacet(Vec3f(0.2F), 0.3F, 1.5F)))), std::pair(false, false))
      << "Nori's has one alone";
  EXPECT_EQ(both(effectsIn(roomWith(roughMetal(Vec3f(0.2F), Vec3f(3.0F), 0.0F, beckmann)))),
            std::pair(false, false))
      << "as smooth as can be";
  const Scene mixed =
      room()
          .quad({-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1}, metalOf(ggx))
          .quad({-1, 0, 1}, {1, 0, 1}, {1, 1, 1}, {-1, 1, 1}, roughGlass(1.5F, 0.3F, beckmann))
          .build();
  EXPECT_EQ(both(effectsIn(mixed)), std::pair(true, true));
}

TEST(Effects, OneSidedIsWhatScattersOnOneSideOnly) {
  const auto oneSided = [](Material m) {
    m.twoSided = false;
    return effectsIn(roomWith(m)).has(Effect::OneSided);
  };
  EXPECT_TRUE(oneSided(diffuse(Vec3f(0.5F))));
  EXPECT_FALSE(oneSided(diffuse(Vec3f(0.0F)))) << "black on both";
  EXPECT_FALSE(oneSided(glass(1.5F))) << "glass has two sides in any case";
}

TEST(Effects, OneLightNeedsNoTable) {
  Scene one = lampOf(kLamp, 1.0);
  EXPECT_TRUE(effectsIn(one).has(Effect::LightSampling));
  EXPECT_FALSE(effectsIn(one).has(Effect::ManyLights));
  addPointLight(one, {0, 1, 0}, Vec3f(0.0F));
  EXPECT_FALSE(effectsIn(one).has(Effect::ManyLights)) << "a light of no power is none";
  EXPECT_FALSE(effectsIn(one).has(Effect::DeltaLights));
  addPointLight(one, {0, 1, 0}, Vec3f(0.1F));
  EXPECT_TRUE(effectsIn(one).has(Effect::ManyLights));
  EXPECT_TRUE(effectsIn(one).has(Effect::DeltaLights));
}

TEST(Effects, WithoutALightThatARayCanHitThereIsNothingToWeigh) {
  Scene scene = SceneBuilder().floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F))).build();
  addPointLight(scene, {0, 1, 0}, Vec3f(1.0F));
  EXPECT_TRUE(effectsIn(scene).has(Effect::LightSampling));
  EXPECT_FALSE(effectsIn(scene).has(Effect::Mis));
  EXPECT_TRUE(effectsIn(lampOf(kLamp, 1.0)).has(Effect::Mis));
  scene.environment = environmentMap(4, 2, [](int, int) { return Vec3f(0.5F); });
  EXPECT_TRUE(effectsIn(scene).has(Effect::Mis));
}

TEST(Effects, ABlackEnvironmentOrBackgroundIsNone) {
  Scene scene = room().build();
  scene.environment = environmentMap(4, 2, [](int, int) { return Vec3f(0.0F); });
  EXPECT_EQ(effectsIn(scene), effectsIn(room().build()));
  scene.environment.radiance[3].y = 1e-6F;
  EXPECT_TRUE(effectsIn(scene).has(Effect::Environment));
  scene.background = {0.0F, 0.0F, 1e-6F};
  EXPECT_TRUE(effectsIn(scene).has(Effect::Background));
}

TEST(Effects, SpecularSurfacesAloneNeedNoLightSampling) {
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 1.0, mirror(Vec3f(0.9F))).ceiling({0, 2, 0}, 0.5, emitter(kLamp));
  const EffectSet set = effectsIn(builder.build());
  EXPECT_TRUE(set.has(Effect::Mirror));
  for (const Effect e : {Effect::LightSampling, Effect::Mis, Effect::ManyLights, Effect::Diffuse})
    EXPECT_FALSE(set.has(e)) << effectName(e);
}

TEST(EffectReasons, NameTheObjectAndItsLine) {
  Material m = mirror(Vec3f(0.9F));
  m.name = "silver";
  m.where = {"room.mtl", 12};
  EXPECT_EQ(reasonFor(roomWith(m), Effect::Mirror).text(), "material 'silver' (room.mtl:12)");
  EXPECT_EQ(reasonFor(room().build(), Effect::Mirror).text(), "needs a triangle with a mirror material");
  m.bsdf = BsdfType::Phong;
  EXPECT_EQ(reasonFor(roomWith(m), Effect::Phong).text(),
            "material 'silver' has the effect of diffuse (room.mtl:12)");
}

TEST(Effects, EachIsCalledForBySomething) {
  EffectSet allButThree = EffectSet::all();
  for (const Effect e :
       {Effect::LightTracing, Effect::PathReuse, Effect::Guiding}) // some of the others are in their way
    allButThree.set(e, false);
  EXPECT_EQ(detectEffects(everything(), everyOption()), allButThree);
  EstimatorSettings shared = misSampling();
  shared.pathReuse = 4;
  EXPECT_TRUE(detectEffects(room().build(), shared).has(Effect::PathReuse));
  EXPECT_FALSE(detectEffects(room().build(), withBounces(shared, 1)).has(Effect::PathReuse));
  EstimatorSettings settings = misSampling();
  settings.lightTracing = LightTracing::Auto;
  const Scene scene = roomWith(glass(1.5F));
  EXPECT_TRUE(detectEffects(scene, settings).has(Effect::LightTracing));
  EXPECT_FALSE(detectEffects(scene, settings).has(Effect::Guiding));
  settings.guiding = Guiding::Auto;
  EXPECT_TRUE(detectEffects(scene, settings).has(Effect::Guiding));
  EXPECT_FALSE(detectEffects(scene, withBounces(settings, 2)).has(Effect::Guiding)) << "nothing to find";
}

/// `count` lamps in a row, `apart` from each other, over a floor of 2 by 2.
Scene lampsInARow(int count, double apart) {
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F)));
  for (int i = 0; i < count; ++i)
    builder.triangle({apart * i - 0.9, 1, 0}, {apart * i - 0.88, 1, 0}, {apart * i - 0.9, 1, 0.02},
                     emitter(Vec3f(1.0F)));
  return builder.build();
}

TEST(Effects, ATreeIsForSeveralLightsThatAreSpreadOut) {
  EstimatorSettings settings = misSampling();
  const auto tree = [&](const Scene& scene) { return explainEffects(scene, settings).of(Effect::LightTree); };
  const auto has = [&](const Scene& scene) { return detectEffects(scene, settings).has(Effect::LightTree); };
  EXPECT_FALSE(has(lampsInARow(20, 0.09)));
  EXPECT_EQ(tree(lampsInARow(20, 0.09)).because, "--light-selection power");
  settings.lightSelection = LightSelection::Auto;
  EXPECT_TRUE(has(lampsInARow(20, 0.09)));
  EXPECT_EQ(tree(lampsInARow(20, 0.09)).because, "20 lights, spread out");
  EXPECT_FALSE(has(lampsInARow(7, 0.25))) << "few";
  EXPECT_FALSE(has(lampsInARow(20, 0.03))) << "in one small place";
  EXPECT_EQ(tree(lampsInARow(20, 0.03)).because, "20 lights that are few or in one small place");
  settings.lightSelection = LightSelection::Tree;
  EXPECT_TRUE(has(lampsInARow(2, 0.01)));
  EXPECT_FALSE(has(lampsInARow(1, 0.01)));
  EXPECT_EQ(tree(lampsInARow(1, 0.01)).because, "one light needs no tree");
}

/// Each option and each part of the scene by itself keeps paths from the lights away, some even where they
/// are asked for.
TEST(Effects, PathsFromTheLightsNeedCausticsAndSpaceForThem) {
  struct Obstacle {
    std::string because;
    bool impossible;
    std::function<void(Scene&, EstimatorSettings&)> put;
  };
  const std::vector<Obstacle> obstacles{
      {"--light-tracing off", false,
       [](Scene&, EstimatorSettings& e) { e.lightTracing = LightTracing::Off; }},
      {"--light bsdf", true, [](Scene&, EstimatorSettings& e) { e.light = LightStrategy::Bsdf; }},
      {"--split 2", true, [](Scene&, EstimatorSettings& e) { e.splitDepth = 2; }},
      {"--output-paths", true, [](Scene&, EstimatorSettings& e) { e.kindImages = true; }},
      {"a filter other than a box of one pixel", true,
       [](Scene& s, EstimatorSettings&) { s.filter.shape = PixelFilter::Shape::Tent; }},
      {"--max-bounces 1: no caustics", false, [](Scene&, EstimatorSettings& e) { e.maxBounces = 1; }},
      {"--paths without caustics", false,
       [](Scene&, EstimatorSettings& e) { e.pathKinds = 1U << shared::kKindDirect; }},
      {"glass that absorbs", true,
       [](Scene& s, EstimatorSettings&) {
         for (Material& m : s.materials)
           m.absorption = Vec3f(m.bsdf == BsdfType::Dielectric ? 1.0F : 0.0F);
       }},
      {"no surface is specular", false,
       [](Scene& s, EstimatorSettings&) {
         for (Material& m : s.materials)
           m.bsdf = BsdfType::Diffuse;
       }},
      {"no surface scatters other than specularly", false,
       [](Scene& s, EstimatorSettings&) {
         for (Material& m : s.materials)
           m.bsdf = BsdfType::Dielectric;
       }},
      {"no triangle emits", false,
       [](Scene& s, EstimatorSettings&) {
         for (Material& m : s.materials)
           m.emission = Vec3f(0.0F);
       }},
  };
  for (const Obstacle& o : obstacles) {
    Scene scene = roomWith(glass(1.5F));
    EstimatorSettings settings = misSampling();
    settings.lightTracing = LightTracing::On;
    EXPECT_FALSE(lightTracingObstacle(scene, settings)) << o.because;
    o.put(scene, settings);
    const auto found = lightTracingObstacle(scene, settings);
    ASSERT_TRUE(found) << o.because;
    EXPECT_EQ(found->reason.text(), o.because);
    EXPECT_EQ(found->impossible, o.impossible) << o.because;
    const EffectReasons reasons = explainEffects(scene, settings);
    EXPECT_FALSE(reasons.set.has(Effect::LightTracing));
    EXPECT_EQ(reasons.of(Effect::LightTracing).because, o.because);
    settings.guiding = Guiding::Auto;
    EXPECT_EQ(explainEffects(scene, settings).of(Effect::Guiding).text(),
              settings.maxBounces < 3 ? "--max-bounces 1: no caustics behind specular surfaces" : o.because);
    const auto constants = [&] { return frameConstants(scene, {}, settings, 8, 8, 0); };
    if (o.impossible)
      EXPECT_THROW(constants(), UsageError) << o.because;
    else
      EXPECT_EQ(constants().tracesLights, 0U);
  }
}

/// At most four, of the surfaces that are specular, together as small as they can be.
TEST(SpecularBoxes, HoldWhatIsSpecular) {
  SceneBuilder builder;
  builder.box({-9, -9, -9}, {9, 9, 9}, Facing::Inward, diffuse(Vec3f(0.5F)));
  for (int i = 0; i < 6; ++i) {
    const Vec3d at(i < 3 ? 0.1 * i : 5.0 + i, 0.0, 0.0);
    builder.box(at, at + Vec3d(0.5), Facing::Outward, mirror(Vec3f(0.1F * static_cast<float>(i + 1))));
  }
  const Scene scene = builder.build();
  EXPECT_EQ(specularBoxes(scene, 6).size(), 6U);
  const std::vector<Box3d> boxes = specularBoxes(scene, 4);
  ASSERT_EQ(boxes.size(), 4U);
  EXPECT_NEAR(glm::length(boxes[0].extent() - Vec3d(0.7, 0.5, 0.5)), 0.0, 1e-6)
      << "the first three, which overlap";
}

TEST(EffectReasons, ComeFromTheWalkThatMakesTheSet) {
  const EffectReasons reasons = explainEffects(variety(), misSampling());
  EXPECT_EQ(reasons.set, detectEffects(variety(), misSampling()));
  for (const EffectInfo& e : allEffects()) {
    const std::string& because = reasons.of(e.effect).because;
    EXPECT_FALSE(because.empty()) << e.name;
    EXPECT_FALSE(reasons.set.has(e.effect) && because.starts_with("needs ")) << e.name;
  }
}

} // namespace
} // namespace vkpt::test
