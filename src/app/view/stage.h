#pragma once
// The scene on the device, and the integrator that renders it: made anew as far as a change of settings asks.

#include "app/options.h"
#include "app/view/view_settings.h"
#include "device/device_scene.h"

#include <memory>

namespace vkpt {

class Stage {
public:
  /// `options` and `scene` must outlive it.
  Stage(const gpu::Context& context, const RenderOptions& options, Scene& scene);

  /// Compiles and packs what these settings call for, unless it is there. The film is empty afterwards.
  void prepare(const ViewSettings& settings);
  /// An empty film of this size, seen by this camera. Throws UsageError where it has no direction.
  void restart(const Camera& camera, Vec2i size);

  [[nodiscard]] Integrator& integrator() { return *m_integrator; }
  [[nodiscard]] const Integrator& integrator() const { return *m_integrator; }
  [[nodiscard]] const Scene& scene() const { return m_scene; }
  [[nodiscard]] const PackedScene& packed() const { return m_packed; }
  [[nodiscard]] const EffectSet& effects() const { return m_effects; }
  [[nodiscard]] const EffectSet& detected() const { return m_detected; }
  [[nodiscard]] Vec2i size() const {
    return {m_integrator->settings().width, m_integrator->settings().height};
  }
  [[nodiscard]] std::uint64_t deviceBytes() const { return m_device.bytes() + m_integrator->filmBytes(); }
  [[nodiscard]] double buildSeconds() const { return m_buildSeconds; }
  [[nodiscard]] double compileSeconds() const { return m_compileSeconds; }

private:
  void pack(const EstimatorSettings& estimator);
  void compile(const EstimatorSettings& estimator, Shader shader);

  const gpu::Context& m_context;
  const RenderOptions& m_options;
  Scene& m_scene;
  EffectSet m_detected;
  EffectSet m_effects;
  PackedScene m_packed;
  DeviceScene m_device;
  std::unique_ptr<Integrator> m_integrator;
  double m_buildSeconds = 0.0; ///< that the last of each took
  double m_compileSeconds = 0.0;
};

} // namespace vkpt
