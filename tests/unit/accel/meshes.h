#pragma once
// Triangles to build trees over: ordinary ones and those that trees are bad at.

#include "core/math.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt::test {

using Triangle = std::array<Vec3f, 3>;
using Mesh = std::vector<Triangle>;

/// Random numbers whose seed is the hash of a name.
class Random {
public:
  explicit Random(std::string_view name);
  /// Uniform in [from, to).
  float uniform(float from, float to);
  Vec3f inBox(float from, float to) {
    const float x = uniform(from, to);
    const float y = uniform(from, to);
    return {x, y, uniform(from, to)};
  }
  /// Uniform over the unit sphere.
  Vec3f direction();

private:
  std::mt19937 m_engine;
};

/// Small triangles scattered in a cube of edge 2.
Mesh soup(std::size_t count, float size, std::string_view seed);
/// A wavy height field of 2 n^2 triangles, as modelled surfaces are: connected and of unequal sizes.
Mesh waves(std::uint32_t n);
/// An axis-aligned plane of 2 n^2 triangles: flat boxes.
Mesh flatGrid(std::uint32_t n);
/// A fan of long thin triangles about one point.
Mesh sliverFan(std::size_t count);
/// Triangles with zero volume, thin and long, in all directions.
Mesh needles(std::size_t count, std::string_view seed);
/// One triangle many times.
Mesh coincident(std::size_t count);
/// Different sizes about one centre: all centroids of the boxes are equal.
Mesh concentric(std::size_t count);
/// Triangle i is `ratio`^i in size and distance.
Mesh geometric(std::size_t count, double ratio);
/// Degenerate triangles on a line: no box has a surface.
Mesh onLine(std::size_t count);
/// The soup above, scaled.
Mesh scaled(Mesh mesh, float factor);
/// One mesh after the other.
Mesh together(const Mesh& a, const Mesh& b);

std::vector<Box3f> boxesOf(const Mesh& mesh);

struct NamedMesh {
  std::string name;
  Mesh mesh;
};
/// Every kind above at a few thousand triangles, huge and tiny scales among them.
std::vector<NamedMesh> allKinds();

} // namespace vkpt::test
