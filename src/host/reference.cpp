#include "host/reference.h"

namespace vkpt {

HostCounters& HostCounters::operator+=(const HostCounters& other) {
  raysClosest += other.raysClosest;
  raysShadow += other.raysShadow;
  cappedPaths += other.cappedPaths;
  nonFinite += other.nonFinite;
  cutTraversal += other.cutTraversal;
  invalidPdf += other.invalidPdf;
  return *this;
}

} // namespace vkpt
