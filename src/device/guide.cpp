#include "device/guide.h"

#include "device/alias_bins.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vkpt {
namespace {

constexpr std::uint32_t kCoarsestEdge = 16; ///< cubes along a grid
constexpr std::uint32_t kFinestEdge = 64;
constexpr std::uint32_t kEnoughPhotons = 64; ///< that a cube of a finer grid takes
static_assert(shared::kGuideBins == 1U << shared::kGuideBits);

using Histogram = std::array<double, shared::kGuideBins>;

Box3d boxOf(std::span<const Photon> photons) {
  Box3d box;
  for (const Photon& p : photons)
    box.extend(Vec3d(p.p));
  return box;
}

/// visit(cube), by number, x fastest, for the eight cubes nearest to a point; those outside are left out.
template<class Visit>
void eachNear(const CubeGrid& grid, const Vec3f& p, const Visit& visit) {
  const auto edge = static_cast<float>(grid.edge);
  const Vec3f q = (p - grid.lower) * grid.cubesPerMetre;
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const auto side = [&](std::uint32_t axis) { return ((corner >> axis) & 1U) != 0U ? 0.5F : -0.5F; };
    const Vec3f at = glm::floor(q + Vec3f(side(0), side(1), side(2)));
    if (at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < edge && at.y < edge && at.z < edge)
      visit(static_cast<std::uint32_t>((at.z * edge + at.y) * edge + at.x));
  }
}

/// By cube; of those with at least so many photons, since a histogram takes 2 KB.
std::map<std::uint32_t, Histogram> histogramsIn(const CubeGrid& grid, std::span<const Photon> photons,
                                                std::uint32_t least) {
  std::map<std::uint32_t, std::uint32_t> count;
  for (const Photon& photon : photons)
    eachNear(grid, photon.p, [&](std::uint32_t cube) { ++count[cube]; });
  std::map<std::uint32_t, Histogram> histograms;
  for (const Photon& photon : photons) {
    eachNear(grid, photon.p, [&](std::uint32_t cube) {
      if (count[cube] >= least)
        histograms[cube][photon.bin] += static_cast<double>(photon.power);
    });
  }
  return histograms;
}

/// The cubes of the finest grid that lie in one of a grid with `edge` cubes along it begin at `start`.
void fill(std::vector<std::uint32_t>& numbers, std::uint32_t edge, std::uint32_t cube, std::uint32_t start) {
  const std::uint32_t parts = kFinestEdge / edge;
  const std::uint32_t x = cube % edge * parts;
  const std::uint32_t y = cube / edge % edge * parts;
  const std::uint32_t z = cube / edge / edge * parts;
  for (std::uint32_t i = 0; i < parts * parts * parts; ++i) {
    numbers[shared::guideCube(x + i % parts, y + i / parts % parts, z + i / parts / parts, kFinestEdge)] =
        start;
  }
}

} // namespace

Guide makeGuide(std::span<const Photon> photons) {
  Guide guide;
  if (photons.empty())
    return guide;
  guide.grid = gridAbout(boxOf(photons), kFinestEdge);
  guide.numbers.assign(std::size_t{kFinestEdge} * kFinestEdge * kFinestEdge, shared::kNoGuide);
  for (std::uint32_t edge = kCoarsestEdge; edge <= kFinestEdge; edge *= 2) {
    const CubeGrid grid{guide.grid.lower, guide.grid.cubesPerMetre / static_cast<float>(kFinestEdge / edge),
                        edge};
    const std::uint32_t least = edge == kCoarsestEdge ? 1 : kEnoughPhotons;
    for (const auto& [cube, histogram] : histogramsIn(grid, photons, least)) {
      fill(guide.numbers, edge, cube, static_cast<std::uint32_t>(guide.numbers.size()));
      appendAliasBins(histogram, guide.numbers);
    }
  }
  return guide;
}

} // namespace vkpt
