#include "embree_scene.h"

#include "embree_ray.h"

#include "shared/structs.h"

#include <bit>
#include <stdexcept>

namespace vkpt::bench {

EmbreeScene::EmbreeScene(const PackedScene& scene)
    : m_device(rtcNewDevice("threads=2")), m_scene(rtcNewScene(m_device.get())) {
  const std::size_t count = scene.bvh.triangleOrder.size();
  rtcSetSceneBuildQuality(m_scene.get(), RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = rtcNewGeometry(m_device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
  for (std::size_t corner = 0; corner < 3 * count; ++corner) {
    for (std::size_t c = 0; c < 3; ++c)
      vertices[3 * corner + c] = std::bit_cast<float>(scene.triangles[corner][c]);
    indices[corner] = static_cast<std::uint32_t>(corner);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(m_scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(m_scene.get());
  if (rtcGetDeviceError(m_device.get()) != RTC_ERROR_NONE)
    throw std::runtime_error("Embree could not build the scene");
}

void EmbreeScene::closest(std::span<const RecordedRay> rays, std::span<float> t) const {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRayHit r = makeRayHit(rays[i].o, rays[i].d);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(handle(), &context, &r);
    t[i] = r.ray.tfar;
  }
}

void EmbreeScene::occluded(std::span<const RecordedRay> rays, std::span<float> hit) const {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRay r = makeRay(rays[i].o, rays[i].d, rays[i].tMax);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(handle(), &context, &r);
    hit[i] = r.tfar < 0.0F ? 1.0F : 0.0F;
  }
}

} // namespace vkpt::bench
