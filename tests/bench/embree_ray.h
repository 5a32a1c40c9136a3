#pragma once
// Embree's ray structs from any vectors with operator[].

#include <embree3/rtcore.h>

#include <limits>

namespace vkpt::bench {

/// Origins are already offset from their surfaces: no tnear.
template<class V>
inline RTCRay makeRay(const V& o, const V& d, float tMax) {
  RTCRay r;
  r.org_x = o[0];
  r.org_y = o[1];
  r.org_z = o[2];
  r.tnear = 0.0F;
  r.dir_x = d[0];
  r.dir_y = d[1];
  r.dir_z = d[2];
  r.time = 0.0F;
  r.tfar = tMax;
  r.mask = 0xFFFFFFFFU;
  r.id = 0;
  r.flags = 0;
  return r;
}

template<class V>
inline RTCRayHit makeRayHit(const V& o, const V& d) {
  RTCRayHit r;
  r.ray = makeRay(o, d, std::numeric_limits<float>::infinity());
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.primID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return r;
}

} // namespace vkpt::bench
