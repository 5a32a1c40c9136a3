#include "scene/twins.h"

#include <bit>

namespace vkpt {

namespace {

constexpr std::uint32_t kFree = 0xFFFFFFFFU;

/// Finaliser of MurmurHash3 (A. Appleby).
std::uint64_t mix(std::uint64_t h) {
  h = (h ^ (h >> 33U)) * 0xFF51AFD7ED558CCDULL;
  h = (h ^ (h >> 33U)) * 0xC4CEB9FE1A85EC53ULL;
  return h ^ (h >> 33U);
}

std::uint64_t hashOf(const Vec3f& p) {
  std::uint64_t h = 0;
  for (int axis = 0; axis < 3; ++axis) {
    h = mix(h + std::bit_cast<std::uint32_t>(p[axis] + 0.0F)); // -0 is 0
  }
  return h;
}

} // namespace

TwinFinder::TwinFinder(const Scene& scene)
    : m_scene(scene), m_slots(std::bit_ceil(2 * scene.triangles.size() + 1), kFree) {}

Twin TwinFinder::find(std::uint32_t index) {
  const Triangle& t = m_scene.triangles[index];
  const std::size_t last = m_slots.size() - 1;
  Twin twin = Twin::None;
  std::size_t slot = hash(t) & last;
  for (; m_slots[slot] != kFree; slot = (slot + 1) & last) {
    const Triangle& other = m_scene.triangles[m_slots[slot]];
    bool sameSide = false;
    if (!onSameCorners(t, other, sameSide)) {
      continue;
    }
    if (sameSide) {
      return t.material == other.material ? Twin::Same : Twin::OtherLook;
    }
    twin = t.material == other.material ? twin : Twin::BackToBack;
  }
  m_slots[slot] = index;
  return twin;
}

/// Of the corners, in whatever order.
std::size_t TwinFinder::hash(const Triangle& t) const {
  std::uint64_t sum = 0;
  for (const std::uint32_t v : t.vertex) {
    sum += hashOf(m_scene.positions[v]);
  }
  return mix(sum);
}

bool TwinFinder::onSameCorners(const Triangle& a, const Triangle& b, bool& sameSide) const {
  const auto corner = [&](const Triangle& t, std::size_t i) { return m_scene.positions[t.vertex[i % 3]]; };
  for (std::size_t first = 0; first < 3; ++first) {
    if (corner(a, 0) != corner(b, first)) {
      continue;
    }
    sameSide = corner(a, 1) == corner(b, first + 1) && corner(a, 2) == corner(b, first + 2);
    if (sameSide || (corner(a, 1) == corner(b, first + 2) && corner(a, 2) == corner(b, first + 1))) {
      return true;
    }
  }
  return false;
}

} // namespace vkpt
