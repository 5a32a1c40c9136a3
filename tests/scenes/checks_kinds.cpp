// Kinds of light path: for each a scene that has it alone, the images that add up, and the masks.
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

constexpr const char* kNames[] = {"emission", "direct",           "caustic",
                                  "indirect", "indirect caustic", "specular"};
constexpr std::uint32_t maskOf(PathKind kind) { return 1U << static_cast<std::uint32_t>(kind); }

using KindImages = std::vector<std::vector<Vec3d>>;
struct Parted {
  Film film;
  KindImages kinds;
};

Parted renderKinds(Trial& t, const Scene& scene, RenderSetup setup) {
  setup.estimator.kindImages = true;
  Studio studio(t.context(), scene, t.complete(setup));
  const Rendered r = studio.render();
  t.expect(r.counters.faults() == 0, fmt::format("{} faults", r.counters.faults()));
  return {r.film, studio.integrator().kindImages(r.film)};
}

Vec3d meanOf(const std::vector<Vec3d>& image) {
  Vec3d sum(0.0);
  for (const Vec3d& p : image)
    sum += p;
  return sum / static_cast<double>(image.size());
}
/// Of the mean of an image whose pixels show one point.
Vec3d standardErrorOf(const std::vector<Vec3d>& image) {
  const Vec3d mean = meanOf(image);
  Vec3d sum(0.0);
  for (const Vec3d& p : image)
    sum += (p - mean) * (p - mean);
  const auto n = static_cast<double>(image.size());
  return glm::sqrt(sum / (n * (n - 1.0)));
}

/// Of a scene seen as one point, the kinds have these means; those that are left out are black.
struct Expected {
  PathKind kind;
  Vec3d radiance;
};
void expectKinds(Trial& t, const Parted& parted, std::initializer_list<Expected> expected, double tolerance,
                 const std::string& what) {
  for (std::uint32_t k = 0; k < kPathKindCount; ++k) {
    Vec3d radiance(0.0);
    for (const Expected& e : expected)
      radiance = static_cast<std::uint32_t>(e.kind) == k ? e.radiance : radiance;
    const Vec3d mean = meanOf(parted.kinds[k]);
    const Vec3d error = standardErrorOf(parted.kinds[k]);
    const bool calm = !t.isShipped() || glm::all(glm::lessThanEqual(3.0 * error, tolerance * radiance));
    const bool near = glm::all(glm::lessThanEqual(glm::abs(mean - radiance), 4.0 * error + 2e-6 * radiance));
    t.expect(near && calm,
             fmt::format("{}: {} is {:.6g} {:.6g} {:.6g} +- {:.2g}, expected {:.6g} {:.6g} {:.6g}{}", what,
                         kNames[k], mean.x, mean.y, mean.z, maxAbs(error), radiance.x, radiance.y, radiance.z,
                         calm ? "" : ": too noisy to tell"));
  }
}

RenderSetup pointOf(const EstimatorSettings& settings, std::uint64_t frames) {
  return {.estimator = settings, .width = 64, .height = 64, .frames = frames};
}

void emissionAndSpecular(Trial& t) {
  SceneBuilder seen;
  seen.floor(Vec3d(0.0), 1.0, emitter(kRadiance)).camera(lookAt({0.1, 2.0, 0.2}, Vec3d(0.0), 10.0));
  expectKinds(t, renderKinds(t, seen.build(), {}), {{PathKind::Emission, kRadiance}}, 0.01, "emitter");
  SceneBuilder mirrored;
  mirrored.floor(Vec3d(0.0), 1.0, mirror(Vec3f(0.5F)))
      .ceiling({0.0, 5.0, 0.0}, 50.0, emitter(kRadiance))
      .camera(lookAt({0.1, 2.0, 0.2}, Vec3d(0.0), 10.0));
  expectKinds(t, renderKinds(t, mirrored.build(), {}), {{PathKind::Specular, 0.5 * Vec3d(kRadiance)}}, 0.01,
              "mirror");
  SceneBuilder through;
  Material clear = glass(1.0F);    // reflects nothing
  clear.absorption = Vec3f(1e-6F); // without any it would be left out; half the space below is behind it
  through.floor(Vec3d(0.0), 1.0, clear).floor({0.0, -1.0, 0.0}, 9.0, emitter(kRadiance));
  through.camera(lookAt({0.1, 2.0, 0.2}, Vec3d(0.0), 10.0));
  expectKinds(t, renderKinds(t, through.build(), {}), {{PathKind::Specular, kRadiance}}, 0.01,
              "through glass");
}

/// By each strategy, and seen in a mirror: E D L and E S D L.
void directAlone(Trial& t) {
  LitFloor lit = litFloor();
  for (const auto& [light, name] : kStrategies) {
    expectKinds(t, renderKinds(t, lit.scene, pointOf(findingLightBy(light), 64)),
                {{PathKind::Direct, lit.radiance}}, 0.02, fmt::format("lit floor by {}", name));
  }
  const Vec3d light[4] = {{-2.0, 1.0, 0.5}, {-1.0, 1.0, 0.5}, {-1.0, 1.0, 1.5}, {-2.0, 1.0, 1.5}};
  const Scene scene =
      SceneBuilder()
          .floor({0.0, 0.0, 0.0}, 0.3, diffuse(kAlbedo))
          .quad(light[0], light[1], light[2], light[3], emitter(kRadiance))
          .quad({1.0, 0.0, 1.0}, {1.0, 0.0, -1.0}, {1.0, 2.0, -1.0}, {1.0, 2.0, 1.0}, mirror(Vec3f(0.5F)))
          .camera(lookAt({0.0, 1.0, 0.0}, {1.0, 0.5, 0.0}, kPointFov)) // and on to the origin
          .build();
  const double irradiance = polygonIrradiance({light[0], light[1], light[2], light[3]}, Vec3d(0.0), kUp);
  const Vec3d radiance = 0.5 * Vec3d(kAlbedo) * Vec3d(kRadiance) * (irradiance / std::numbers::pi);
  expectKinds(t, renderKinds(t, scene, pointOf(withBounces(lightSampling(), 2), 16)),
              {{PathKind::Direct, radiance}}, 0.02, "in a mirror");
}

/// A lamp turned to a mirror and away from the floor: D Sr L.
void mirrorCaustic(Trial& t) {
  const Vec3d image[4] = {{3.5, 0.5, -0.5}, {3.5, 0.5, 0.5}, {3.5, 1.5, 0.5}, {3.5, 1.5, -0.5}};
  const Scene scene =
      SceneBuilder()
          .floor(Vec3d(0.0), 0.1, diffuse(kAlbedo))
          .quad({2.0, -5.0, 9.0}, {2.0, -5.0, -9.0}, {2.0, 9.0, -9.0}, {2.0, 9.0, 9.0}, mirror(Vec3f(0.5F)))
          .quad({0.5, 0.5, 0.5}, {0.5, 0.5, -0.5}, {0.5, 1.5, -0.5}, {0.5, 1.5, 0.5}, emitter(kRadiance))
          .camera(lookAt({-1.0, 1.0, 0.1}, Vec3d(0.0), kPointFov))
          .build();
  const double irradiance = polygonIrradiance({image[0], image[1], image[2], image[3]}, Vec3d(0.0), kUp);
  const Vec3d radiance = 0.5 * Vec3d(kAlbedo) * Vec3d(kRadiance) * (irradiance / std::numbers::pi);
  for (const EstimatorSettings& settings : {lightSampling(), misSampling()})
    expectKinds(t, renderKinds(t, scene, pointOf(settings, 400)), {{PathKind::Caustic, radiance}}, 0.04,
                "mirror");
}

/// Integral of f(cosine) cosine over the hemisphere / pi, by the midpoint rule in the cosine.
template<class F>
double cosineMean(F f) {
  constexpr int kCells = 20000;
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i) {
    const double cosine = (i + 0.5) / kCells;
    sum += 2.0 * f(cosine) * cosine / kCells;
  }
  return sum;
}

/// A point under an endless pane and an endless lamp: D St St L is (1 - R)^2 of the light; what is reflected
/// within the pane on its way is an indirect caustic, the rest of (1 - R) / (1 + R).
void paneCaustic(Trial& t) {
  const Scene scene = SceneBuilder()
                          .floor(Vec3d(0.0), 0.01, diffuse(kAlbedo))
                          .ceiling({0.0, 1.0, 0.0}, 1000.0, glass(1.5F))
                          .floor({0.0, 1.2, 0.0}, 1000.0, glass(1.5F))
                          .ceiling({0.0, 3.0, 0.0}, 2500.0, emitter(kRadiance))
                          .floor({0.0, -3.0, 0.0}, 5000.0, diffuse(Vec3f(0.0F)))
                          .camera(lookAt({-0.5, 0.6, 0.1}, Vec3d(0.0), kPointFov))
                          .build();
  const double plain = cosineMean([](double c) { return std::pow(1.0 - exactFresnelDielectric(c, 1.5), 2); });
  const double all = cosineMean([](double c) {
    const double r = exactFresnelDielectric(c, 1.5);
    return (1.0 - r) / (1.0 + r);
  });
  const Vec3d lamp = Vec3d(kAlbedo) * Vec3d(kRadiance);
  const Parted parted = renderKinds(t, scene, pointOf(misSampling(), 100));
  expectKinds(t, parted,
              {{PathKind::Caustic, lamp * plain}, {PathKind::IndirectCaustic, lamp * (all - plain)}}, 0.1,
              "pane");
}

/// The lamp within the glass: D St L, an indirect caustic since it never leaves again.
void lampInGlass(Trial& t) {
  const Scene scene = SceneBuilder()
                          .floor(Vec3d(0.0), 0.01, diffuse(kAlbedo))
                          .ceiling({0.0, 1.0, 0.0}, 1000.0, glass(1.5F))
                          .ceiling({0.0, 3.0, 0.0}, 2500.0, emitter(kRadiance))
                          .floor({0.0, -3.0, 0.0}, 5000.0, diffuse(Vec3f(0.0F)))
                          .camera(lookAt({-0.5, 0.6, 0.1}, Vec3d(0.0), kPointFov))
                          .build();
  const double share = cosineMean([](double c) { return 1.0 - exactFresnelDielectric(c, 1.5); });
  expectKinds(t, renderKinds(t, scene, pointOf(misSampling(), 40)),
              {{PathKind::IndirectCaustic, Vec3d(kAlbedo) * Vec3d(kRadiance) * share}}, 0.02,
              "lamp in glass");
}

/// Every wall emits: 1, a, and a^2 + a^3 to three bounces, without a rounding. And each alone by its mask.
void furnaceKinds(Trial& t) {
  const Vec3d albedo(0.5, 0.25, 0.75);
  const EstimatorSettings settings = withBounces(withoutRoulette(bsdfSampling()), 3);
  const Parted parted = renderKinds(t, furnace(Vec3f(albedo)), {.estimator = settings, .frames = 20});
  const Vec3d indirect = albedo * albedo + albedo * albedo * albedo;
  expectKinds(t, parted,
              {{PathKind::Emission, Vec3d(1.0)}, {PathKind::Direct, albedo}, {PathKind::Indirect, indirect}},
              0.01, "furnace");
  const std::pair<std::uint32_t, Vec3d> masks[] = {
      {maskOf(PathKind::Emission), Vec3d(1.0)},
      {maskOf(PathKind::Direct), albedo},
      {maskOf(PathKind::Indirect), indirect},
      {maskOf(PathKind::Emission) | maskOf(PathKind::Indirect), 1.0 + indirect},
      {maskOf(PathKind::Caustic) | maskOf(PathKind::Specular), Vec3d(0.0)},
  };
  for (const auto& [mask, radiance] : masks) {
    EstimatorSettings masked = settings;
    masked.pathKinds = mask;
    const Film film = t.render(furnace(Vec3f(albedo)), {.estimator = masked, .frames = 4}).film;
    t.expectConstant(film, radiance, 0, fmt::format("kinds {:06b}", mask));
  }
}

/// Of the scene with everything in it: the images add up to the whole, pixel by pixel, and each is what its
/// mask renders: the same paths, fewer of them traced to their end.
void kindsPartTheWhole(Trial& t) {
  Scene scene = variety();
  scene.filter = {PixelFilter::Shape::Mitchell, 2.0, 0.5, 1.0 / 3.0, 1.0 / 3.0};
  EstimatorSettings settings = misSampling();
  settings.splitDepth = 3;
  RenderSetup setup{
      .estimator = settings, .width = 24, .height = 24, .frames = 37, .seed = seedOf("kindsPartTheWhole")};
  const Parted parted = renderKinds(t, scene, setup);
  double worst = 0.0;
  for (std::size_t p = 0; p < parted.film.pixels.size(); ++p) {
    Vec3d sum(0.0);
    for (const auto& kind : parted.kinds)
      sum += kind[p];
    const PixelMoments& pixel = parted.film.pixels[p];
    const double size = maxAbs(pixel.mean) + std::sqrt(maxAbs(pixel.m2) / static_cast<double>(pixel.count));
    worst = std::max(worst, maxAbs(sum - pixel.mean) / size);
  }
  t.expect(worst < 5e-6, fmt::format("the kinds' sum is {:.2g} off the whole", worst));
  for (std::uint32_t k = 0; k < kPathKindCount; ++k) {
    setup.estimator.pathKinds = 1U << k;
    const Film film = t.render(scene, setup).film;
    const Vec3d mean = meanOf(parted.kinds[k]);
    t.expect(mean.x > 0.0, fmt::format("no {} in the scene", kNames[k]));
    std::size_t different = 0;
    for (std::size_t p = 0; p < film.pixels.size(); ++p)
      different +=
          maxAbs(film.pixels[p].mean - parted.kinds[k][p]) > 1e-4 * maxAbs(parted.film.pixels[p].mean) ? 1U
                                                                                                       : 0U;
    // Compilers round the two kernels differently, and a path or two goes elsewhere.
    t.expect(different <= film.pixels.size() / 50, fmt::format("{} of {} pixels of {} differ from its mask's",
                                                               different, film.pixels.size(), kNames[k]));
  }
}

/// A path that outlasts its dispatch stays what it is: in a long furnace no emission is seen but the first.
void carriedHistory(Trial& t) {
  const Scene scene = furnace(Vec3f(0.99F));
  RenderSetup setup{.estimator = bsdfSampling(), .width = 8, .height = 8, .frames = 16};
  const Parted parted = renderKinds(t, scene, setup);
  const Vec3d emission = meanOf(parted.kinds[static_cast<std::size_t>(PathKind::Emission)]);
  t.expect(emission == Vec3d(1.0), fmt::format("emission seen is {:.6g}, expected 1", emission.x));
}

constexpr Check kKindChecks[] = {
    {"emissionAndSpecular", emissionAndSpecular},
    {"furnaceKinds", furnaceKinds},
    {"carriedHistory", carriedHistory},
    {"lampInGlass", lampInGlass},
    {"directAlone", directAlone},
    {"paneCaustic", paneCaustic},
    {"mirrorCaustic", mirrorCaustic},
    {"kindsPartTheWhole", kindsPartTheWhole},
};

} // namespace

std::span<const Check> kindChecks() { return kKindChecks; }

} // namespace vkpt::test
