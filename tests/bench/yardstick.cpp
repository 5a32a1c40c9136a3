#include "yardstick.h"

#include "embree_ray.h"

#include "device/camera_frame.h"
#include "host/program_headers.h"

#include <pmmintrin.h>
#include <xmmintrin.h>

namespace vkpt::bench {
using Float = float;
#define VKPT_FOREIGN_TRAVERSAL "embree_traversal.inl"
#include "host/program.inl"
#undef VKPT_FOREIGN_TRAVERSAL

namespace {

constexpr std::uint64_t bitsOf(std::initializer_list<Effect> effects) {
  std::uint64_t bits = 0;
  for (const Effect e : effects)
    bits |= std::uint64_t{1} << static_cast<std::uint32_t>(e);
  return bits;
}

constexpr std::initializer_list<Effect> kBoxEffects = {Effect::Diffuse,    Effect::AreaLights,
                                                       Effect::ManyLights, Effect::LightSampling,
                                                       Effect::Roulette,   Effect::Mis};
constexpr std::uint64_t kBlocks = bitsOf(kBoxEffects);
constexpr std::uint64_t kLights = kBlocks | bitsOf({Effect::LightTree});
constexpr std::uint64_t kMesh = kBlocks | bitsOf({Effect::SmoothNormals});
constexpr std::uint64_t kSpheres = kMesh | bitsOf({Effect::Glass, Effect::Metal});
constexpr std::uint64_t kBusts = kMesh | bitsOf({Effect::Phong, Effect::OneSided, Effect::PixelFilter});

template<std::uint64_t kBits, bool kRecord>
struct Traits : FixedEffects<kBits> {
  static constexpr bool kRecords = kRecord;
};

bool equals(const EffectSet& effects, std::uint64_t bits) {
  for (const EffectInfo& e : allEffects()) {
    if (effects.has(e.effect) != (((bits >> static_cast<std::uint32_t>(e.effect)) & 1U) != 0U))
      return false;
  }
  return true;
}

/// use(Program) with the one that has exactly these effects.
template<bool kRecord, class Use>
void withProgram(const PackedScene& scene, const EmbreeScene& embree, const Scene& source,
                 const EffectSet& effects, const HostSettings& s, const Use& use) {
  const FrameConstants constants =
      frameConstants(source, scene.lightChoice, s.estimator, s.width, s.height, s.seed);
  bool found = false;
  const auto attempt = [&]<std::uint64_t kBits>(std::integral_constant<std::uint64_t, kBits>) {
    if (!equals(effects, kBits))
      return;
    found = true;
    Program<Traits<kBits, kRecord>> program(scene, constants, effects, s.estimator.roulette,
                                            source.filter.shape);
    program.embree = embree.handle();
    use(program);
  };
  attempt(std::integral_constant<std::uint64_t, kBlocks>{});
  attempt(std::integral_constant<std::uint64_t, kLights>{});
  attempt(std::integral_constant<std::uint64_t, kSpheres>{});
  attempt(std::integral_constant<std::uint64_t, kMesh>{});
  attempt(std::integral_constant<std::uint64_t, kBusts>{});
  if (!found)
    throw std::runtime_error(
        "the yardstick is not compiled for this scene's effects: tests/bench/yardstick.cpp");
}

/// Embree asks for this; it would be slower without.
class FlushDenormals {
public:
  FlushDenormals() {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() { _mm_setcsr(m_saved); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
  unsigned m_saved = _mm_getcsr();
};

RecordedRay recorded(const auto& ray) {
  return {{ray.o.x, ray.o.y, ray.o.z}, 0, {ray.d.x, ray.d.y, ray.d.z}, ray.exclude};
}

} // namespace

HostRender renderYardstick(const PackedScene& scene, const EmbreeScene& embree, const Scene& source,
                           const EffectSet& effects, const HostSettings& settings, std::uint64_t frames) {
  const FlushDenormals flush;
  HostRender render;
  withProgram<false>(scene, embree, source, effects, settings, [&](const auto& program) {
    render = renderWith([&] { return program; }, settings.width, settings.height, frames, 1);
  });
  return render;
}

RaySet recordRays(const PackedScene& scene, const EmbreeScene& embree, const Scene& source,
                  const EffectSet& effects, const HostSettings& settings) {
  RaySet set;
  withProgram<true>(scene, embree, source, effects, settings, [&](auto& program) {
    program.shadowRays = &set.shadow;
    const auto width = static_cast<uint>(settings.width);
    const uint blocksX = width / kBlockEdge;
    const uint pixels = width * static_cast<uint>(settings.height);
    for (uint slot = 0; slot < pixels;
         ++slot) { // as pixelOfSlot in shaders/device_memory.glsl, without stripes
      const uint block = slot / kBlockPixels;
      const uint lane = slot % kBlockPixels;
      const uint x =
          (block % blocksX) * kBlockEdge + ((lane & 1U) | ((lane >> 1U) & 2U) | ((lane >> 2U) & 4U));
      const uint y =
          (block / blocksX) * kBlockEdge + (((lane >> 1U) & 1U) | ((lane >> 2U) & 2U) | ((lane >> 3U) & 4U));
      auto path = program.cameraPath(y * width + x, x, y, 0, settings.seed);
      set.primary.push_back(recorded(path.ray));
      if (program.Li(path))
        set.bounce.push_back(recorded(path.ray));
    }
  });
  return set;
}

} // namespace vkpt::bench
