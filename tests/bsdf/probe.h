#pragma once
// The library's sampling routines on the device, one at a time.

#include "device/device_scene.h"
#include "gpu/compute_pipeline.h"
#include "scenes/render_fixture.h"

#include <array>
#include <span>
#include <vector>

namespace vkpt::test {

/// A viewer and a surface, as a BSDF sees them.
struct View {
  std::uint32_t material = 0; ///< index into the scene's
  Vec3f wo{0.0F};             ///< unit, on n's side
  Vec3f n{0.0F};              ///< unit: shading and geometric normal
  bool front = true;          ///< seen from the material's front
};

struct BsdfDraw {
  Vec3f wi;
  float pdf_w; ///< 0: specular
  Vec3f weight;
  float unused;
  /// False for a draw that led where the surface doesn't scatter.
  [[nodiscard]] bool scatters() const { return weight != Vec3f(0.0F); }
};
struct BsdfAnswer {
  Vec3f f;
  float pdf_w;
  std::array<float, 4> unused;
};
struct LightDraw {
  Vec3f wi;
  float pdf_w;
  Vec3f end;  ///< of the shadow ray
  float kind; ///< triangle in BVH order; -1 environment, -2 directional, -3 point light
};
struct EnvironmentDraw {
  Vec3f wi;
  float pdf_w;
  Vec3f L;
  float pdfAt; ///< density that a ray in this direction would find
};
struct FilterDraw {
  float offset; ///< pixels
  float weight;
  std::array<float, 6> unused;
};

class Probe {
public:
  /// `mutation`: as in Kernel. Only `effects` are compiled in.
  Probe(const Scene& scene, const EffectSet& effects, std::uint32_t mutation = 0);

  [[nodiscard]] std::vector<BsdfDraw> sampleBsdf(const View& view, std::uint32_t count, std::uint32_t seed);
  [[nodiscard]] std::vector<BsdfAnswer> evaluateBsdf(const View& view, std::span<const Vec3f> directions);
  [[nodiscard]] std::vector<LightDraw> sampleLight(const Vec3f& p, std::uint32_t count, std::uint32_t seed,
                                                   const Vec3f& n = Vec3f(0.0F));
  [[nodiscard]] std::vector<EnvironmentDraw> sampleEnvironment(std::uint32_t count, std::uint32_t seed);
  [[nodiscard]] std::vector<FilterDraw> sampleFilter(std::uint32_t count, std::uint32_t seed);

  [[nodiscard]] const PackedScene& packed() const { return m_packed; }
  [[nodiscard]] const shared::FrameConstants& constants() const { return m_constants; }

private:
  enum class Routine : std::uint32_t {
    SampleBsdf,
    EvaluateBsdf,
    SampleLight,
    SampleEnvironment,
    SampleFilter
  };
  using Query = std::vector<std::array<float, 4>>;
  template<class Answer>
  std::vector<Answer> run(Routine routine, const Query& query, std::uint32_t count, std::uint32_t seed);
  const gpu::ComputePipeline& pipeline(Routine routine);

  PackedScene m_packed;
  shared::FrameConstants m_constants;
  DeviceScene m_scene;
  gpu::BindingSet m_bindings;
  gpu::Buffer m_frame;
  gpu::SpecialisationMap m_specialisation;
  std::uint32_t m_mutation;
  std::map<Routine, gpu::ComputePipeline> m_pipelines;
};

} // namespace vkpt::test
