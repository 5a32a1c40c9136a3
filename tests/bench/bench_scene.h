#pragma once
// A scene with all that the benchmarks of it need, ready to run.

#include "embree_scene.h"
#include "host/reference.h"
#include "render/render_loop.h"
#include "scene/scene.h"
#include "trace_probe.h"

namespace vkpt::bench {

/// vkpt's side.
class DeviceBench {
public:
  DeviceBench(const gpu::Context& context, std::string name, Scene scene);

  [[nodiscard]] std::uint64_t samplesPerRun(std::uint64_t frames) const;
  /// `frames` samples for every pixel. Returns the seconds of rendering.
  double render(std::uint64_t frames);
  [[nodiscard]] const Film& film() const { return m_film; }

protected:
  const gpu::Context& m_context;
  std::string m_name;
  Scene m_scene;
  HostSettings m_settings;
  EffectSet m_effects;
  PackedScene m_packed;
  DeviceScene m_deviceScene;
  Integrator m_integrator;
  Film m_film;
};

/// Both sides.
class SceneBench : public DeviceBench {
public:
  SceneBench(const gpu::Context& context, std::string sceneName, Scene scene);

  [[nodiscard]] const std::string& name() const { return m_name; }
  [[nodiscard]] const Scene& scene() const { return m_scene; }
  [[nodiscard]] const EmbreeScene& embree() const { return m_embree; }

  void renderYardstick(std::uint64_t frames);
  /// One line if vkpt and the yardstick, who used the same random numbers, don't show the same image.
  [[nodiscard]] std::string disagreement() const;

  struct RayBench {
    std::string name; ///< "primary", "bounce", "shadow"
    bool shadow;
    std::vector<RecordedRay> rays;
    TraceProbe probe;
    std::vector<float> embreeResults;
    float rounding; ///< of a distance, by the scene's largest coordinate
    RayBench(const gpu::Context& context, const DeviceScene& scene, std::string name, bool shadow,
             std::vector<RecordedRay> recorded, float largestCoordinate);
    void runEmbree(const EmbreeScene& embree);
    /// Share of rays whose results differ by more than 1e-4 of the distance and the rounding.
    [[nodiscard]] double disagreement() const;
  };
  std::vector<std::unique_ptr<RayBench>>& rayBenches() { return m_rays; }

private:
  EmbreeScene m_embree;
  HostRender m_yardstick;
  std::vector<std::unique_ptr<RayBench>> m_rays;
};

} // namespace vkpt::bench
