#pragma once
// One setting of a study on the device: its integrator and its clock.

#include "render/dispatch_sizer.h"
#include "render/integrator.h"
#include "study/study_result.h"

#include <memory>
#include <optional>

namespace vkpt {

class SettingRun {
public:
  SettingRun(const gpu::Context& context, const Scene& scene, const StudySetting& setting);

  void restart(std::uint32_t seed);
  /// A batch of frames, cut short where the next look or a limit comes first; at least one frame.
  void step(const std::optional<std::uint64_t>& frameLimit, const std::optional<double>& secondLimit);
  /// A limit is met, or less than half a frame is left to it.
  [[nodiscard]] bool finished(const std::optional<std::uint64_t>& frameLimit,
                              const std::optional<double>& secondLimit) const;
  /// The frames are a power of two: points at equal frames for all settings.
  [[nodiscard]] bool isLookDue() const;

  [[nodiscard]] std::uint64_t frames() const { return m_frames; }
  [[nodiscard]] double seconds() const { return m_seconds; }
  [[nodiscard]] Film film() const { return m_integrator->film(); }
  [[nodiscard]] double compileSeconds() const { return m_compileSeconds; }
  [[nodiscard]] std::uint64_t faults() const { return m_integrator->counters().faults(); }
  [[nodiscard]] Integrator& integrator() { return *m_integrator; }

private:
  Scene m_scene; ///< with the setting's filter
  std::uint32_t m_batch;
  DeviceScene m_deviceScene;
  std::unique_ptr<Integrator> m_integrator;
  DispatchSizer m_sizer;
  std::uint64_t m_frames = 0;
  double m_seconds = 0.0;
  double m_compileSeconds = 0.0;
};

} // namespace vkpt
