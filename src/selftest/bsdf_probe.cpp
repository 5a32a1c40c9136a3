#include "selftest/bsdf_probe.h"

#include "device/effective_material.h"
#include "host/program32.h"

namespace vkpt {
namespace {

using Library = host32::Program<RuntimeEffects>;

Scene triangleOf(const Material& material) {
  Scene scene;
  scene.positions = {Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
  Triangle triangle;
  triangle.vertex = {0, 1, 2};
  triangle.normal = {kNoNormal, kNoNormal, kNoNormal};
  triangle.uv = {kNoUv, kNoUv, kNoUv};
  scene.triangles = {triangle};
  scene.materials = {material};
  scene.materials.front().texture = kNoTexture;
  return scene;
}

host32::Vec3 toFloat(const Vec3d& v) { return host32::Vec3(v); }

} // namespace

struct BsdfProbe::Program {
  explicit Program(const Material& material)
      : scene(triangleOf(material)), packed(packScene(scene, {}, 1)),
        library(packed, shared::FrameConstants{}, detectEffects(scene, {}), RouletteMode::Throughput) {}

  Library::Surface seenFrom(const Vec3d& wo) {
    Library::Hit hit{};
    hit.triangle = 0;
    hit.b1 = 0.25;
    hit.b2 = 0.25;
    return library.surfaceAt(hit, toFloat(wo));
  }

  Scene scene;
  PackedScene packed;
  Library library;
};

BsdfProbe::BsdfProbe(const Material& material) : m_program(std::make_unique<Program>(material)) {}
BsdfProbe::~BsdfProbe() = default;

BsdfProbe::Sample BsdfProbe::sample(const Vec3d& wo, std::uint32_t seed, std::uint32_t stream,
                                    std::uint32_t index) const {
  Library& library = m_program->library;
  const Library::Surface surface = m_program->seenFrom(wo);
  if (!library.scattersHere(surface))
    return {};
  const auto random = library.randomBlock(stream, index, library.blockBsdf(0), seed);
  const Library::BsdfSample sample = library.sampleBsdf(surface, toFloat(wo), random);
  return {Vec3d(sample.wi), Vec3d(sample.weight)};
}

double BsdfProbe::density(const Vec3d& wo, const Vec3d& wi) const {
  Library& library = m_program->library;
  const Library::Surface surface = m_program->seenFrom(wo);
  if (!library.scattersHere(surface) || !library.scattersTo(surface, toFloat(wi)))
    return 0;
  return static_cast<double>(library.evaluateBsdf(surface, toFloat(wo), toFloat(wi)).pdf_w);
}

bool BsdfProbe::hasDensity() const {
  return m_program->library.isSmooth(
      static_cast<std::uint32_t>(effectiveBsdf(m_program->scene.materials.front())));
}

} // namespace vkpt
