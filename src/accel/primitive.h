#pragma once
// What the builder moves around: boxes as two groups of four floats, so that a union is two vector
// instructions.

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace vkpt::accel {

using Lanes = std::array<float, 4>;

inline Lanes lanesMin(const Lanes& a, const Lanes& b) {
  Lanes r;
  for (int i = 0; i < 4; ++i)
    r[i] = a[i] < b[i] ? a[i] : b[i];
  return r;
}
inline Lanes lanesMax(const Lanes& a, const Lanes& b) {
  Lanes r;
  for (int i = 0; i < 4; ++i)
    r[i] = a[i] > b[i] ? a[i] : b[i];
  return r;
}

/// A box in lanes 0-2; lane 3 means nothing. Trivial, so that arrays of it need not be initialised.
struct Bounds {
  alignas(16) Lanes lower, upper;

  static Bounds none() {
    constexpr float kMax = std::numeric_limits<float>::max();
    return {{kMax, kMax, kMax, kMax}, {-kMax, -kMax, -kMax, -kMax}};
  }
  void extend(const Lanes& p) {
    lower = lanesMin(lower, p);
    upper = lanesMax(upper, p);
  }
  void extend(const Bounds& b) {
    lower = lanesMin(lower, b.lower);
    upper = lanesMax(upper, b.upper);
  }
  /// In double: extents up to the largest float neither overflow nor vanish when multiplied.
  [[nodiscard]] double extent(int axis) const {
    return static_cast<double>(upper[axis]) - static_cast<double>(lower[axis]);
  }
  [[nodiscard]] double halfArea() const {
    const double x = extent(0);
    const double y = extent(1);
    const double z = extent(2);
    return x * y + y * z + z * x;
  }
  [[nodiscard]] double length() const { return extent(0) + extent(1) + extent(2); }
};

/// A triangle's box; lane 3 of `lower` carries the bits of its index.
struct Primitive : Bounds {
  [[nodiscard]] std::uint32_t index() const { return std::bit_cast<std::uint32_t>(lower[3]); }
  void setIndex(std::uint32_t i) { lower[3] = std::bit_cast<float>(i); }

  /// Half the centre: differences of two of them are finite for every finite box.
  [[nodiscard]] float centroid(int axis) const { return 0.25F * lower[axis] + 0.25F * upper[axis]; }
  [[nodiscard]] Lanes centroid() const { return {centroid(0), centroid(1), centroid(2), 0.0F}; }
};
static_assert(sizeof(Primitive) == 32);

/// What a split needs to know of a range of primitives.
struct Extent {
  Bounds bounds, centroids;

  static Extent none() { return {Bounds::none(), Bounds::none()}; }
  void extend(const Primitive& p) {
    bounds.extend(p);
    centroids.extend(p.centroid());
  }
  void extend(const Extent& e) {
    bounds.extend(e.bounds);
    centroids.extend(e.centroids);
  }
};

} // namespace vkpt::accel
