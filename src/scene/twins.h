#pragma once
// Triangles that lie exactly on others.

#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace vkpt {

enum class Twin {
  None,
  Same,       ///< the corners, the side and the material of an earlier one
  OtherLook,  ///< its corners and its side, but another material
  BackToBack, ///< its corners, the other side, and another material
};

/// Looks among the triangles that were given to it before. Corners are compared as floats, in any rotation;
/// by a table of two indices a triangle, so in constant time each.
class TwinFinder {
public:
  /// For all triangles of `scene`, whose positions are final.
  explicit TwinFinder(const Scene& scene);

  /// What triangle `index` is; it is remembered unless it has an earlier one's corners and side.
  Twin find(std::uint32_t index);

private:
  [[nodiscard]] std::size_t hash(const Triangle& t) const;
  [[nodiscard]] bool onSameCorners(const Triangle& a, const Triangle& b, bool& sameSide) const;

  const Scene& m_scene;
  std::vector<std::uint32_t> m_slots; ///< of a power of two, half of them free
};

} // namespace vkpt
