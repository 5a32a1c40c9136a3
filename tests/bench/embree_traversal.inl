// Stands in for shaders/lib/traverse.glsl inside the yardstick's Program: Embree's traversal. That a ray
// starts off its surface and ends off the light is enough; triangles are not excluded by number, which would
// cost a callback.

RTCScene embree = nullptr;
std::vector<RecordedRay>* shadowRays = nullptr; // where they go, if Traits::kRecords

Hit traceClosest(const Ray& ray) {
  RTCRayHit r = makeRayHit(ray.o, ray.d);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree, &context, &r);
  Hit hit;
  hit.t = r.ray.tfar;
  hit.b1 = r.hit.u;
  hit.b2 = r.hit.v;
  hit.triangle = r.hit.primID; // RTC_INVALID_GEOMETRY_ID is kNoTriangle
  hit.id = r.hit.primID;
  reportClosestRay();
  return hit;
}

bool traceOccluded(const Ray& ray, Float tMax, uint target) {
  if (!(tMax > 0))
    return false;
  if constexpr (Traits::kRecords)
    shadowRays->push_back({{ray.o.x, ray.o.y, ray.o.z}, tMax, {ray.d.x, ray.d.y, ray.d.z}, target});
  RTCRay r = makeRay(ray.o, ray.d, tMax);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree, &context, &r);
  reportShadowRay(true);
  return r.tfar < 0;
}
