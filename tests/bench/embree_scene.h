#pragma once
// The triangles of a PackedScene in Embree, in the same order.

#include "device/packed_scene.h"
#include "rays.h"

#include <embree3/rtcore.h>

#include <memory>
#include <span>

namespace vkpt::bench {

class EmbreeScene {
public:
  explicit EmbreeScene(const PackedScene& scene);
  [[nodiscard]] RTCScene handle() const { return m_scene.get(); }

  /// Distances of the closest hits, infinity where there is none.
  void closest(std::span<const RecordedRay> rays, std::span<float> t) const;
  /// 1 where something lies before tMax, else 0.
  void occluded(std::span<const RecordedRay> rays, std::span<float> hit) const;

private:
  struct Release {
    void operator()(RTCDevice d) const { rtcReleaseDevice(d); }
    void operator()(RTCScene s) const { rtcReleaseScene(s); }
  };
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> m_device;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> m_scene;
};

} // namespace vkpt::bench
