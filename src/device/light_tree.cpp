#include "device/light_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>

namespace vkpt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint32_t kLightBins = 12;

double angleOf(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }

/// Solid angle of the directions that lights below shine in, weighed by their cosine; the paper's
/// section 4.4.
double orientationMeasure(const LightBounds& b) {
  const double spread = angleOf(b.cosSpread);
  const double widest = std::min(spread + 0.5 * kPi, kPi);
  return 2.0 * kPi * (1.0 - std::cos(spread)) +
         0.5 * kPi *
             (2.0 * widest * std::sin(spread) - std::cos(spread - 2.0 * widest) -
              2.0 * spread * std::sin(spread) + std::cos(spread));
}

/// Lights in a row or in one place have no surface: a floor keeps their powers and directions in the sum.
double costOf(const LightBounds& b, double leastSurface) {
  return b.power * orientationMeasure(b) * (b.box.halfArea() + leastSurface);
}

class LightTreeBuilder {
public:
  explicit LightTreeBuilder(std::vector<LightBounds> lights)
      : m_lights(std::move(lights)), m_order(m_lights.size()) {
    std::iota(m_order.begin(), m_order.end(), 0U);
  }
  LightTree build();

private:
  /// Lights m_order[begin, end) that become node `node`.
  struct Range {
    std::uint32_t begin, end, node, depth;
    [[nodiscard]] std::uint32_t size() const { return end - begin; }
  };
  struct Cut {
    int axis;
    std::uint32_t bin;
    double cost;
  };
  struct Bins {
    Box3d centres;
    [[nodiscard]] std::uint32_t of(const LightBounds& light, int axis) const {
      const double along = (light.box.centre()[axis] - centres.lower[axis]) / centres.extent()[axis];
      return std::min(static_cast<std::uint32_t>(along * kLightBins), kLightBins - 1U);
    }
  };

  [[nodiscard]] std::span<std::uint32_t> lightsOf(const Range& r) {
    return std::span(m_order).subspan(r.begin, r.size());
  }
  LightBounds boundsOf(const Range& r);
  std::optional<Cut> cheapestCut(const Range& r, const Bins& bins, const LightBounds& whole);
  std::uint32_t divide(const Range& r, const LightBounds& whole);

  std::vector<LightBounds> m_lights;
  std::vector<std::uint32_t> m_order;
};

LightBounds LightTreeBuilder::boundsOf(const Range& r) {
  LightBounds bounds = m_lights[m_order[r.begin]];
  for (const std::uint32_t i : lightsOf(r).subspan(1))
    bounds = unite(bounds, m_lights[i]);
  return bounds;
}

std::optional<LightTreeBuilder::Cut> LightTreeBuilder::cheapestCut(const Range& r, const Bins& bins,
                                                                   const LightBounds& whole) {
  const Vec3d extent = whole.box.extent();
  const double longest = std::max({extent.x, extent.y, extent.z});
  const double leastSurface = 1e-6 * longest * longest;
  std::optional<Cut> best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(bins.centres.extent()[axis] > 0.0))
      continue;
    std::array<std::optional<LightBounds>, kLightBins> in;
    const auto add = [](std::optional<LightBounds>& to, const LightBounds& b) {
      to = to ? unite(*to, b) : b;
    };
    for (const std::uint32_t i : lightsOf(r))
      add(in[bins.of(m_lights[i], axis)], m_lights[i]);
    std::array<double, kLightBins> right{}; // cost of the bins from this one on
    std::optional<LightBounds> sum;
    for (std::uint32_t b = kLightBins - 1; b > 0; --b) {
      if (in[b])
        add(sum, *in[b]);
      right[b] = sum ? costOf(*sum, leastSurface) : 0.0;
    }
    sum.reset();
    // Thin boxes are cut across: the paper's regularisation.
    const double thin = longest / extent[axis];
    for (std::uint32_t b = 1; b < kLightBins; ++b) {
      if (in[b - 1])
        add(sum, *in[b - 1]);
      if (!sum || right[b] == 0.0)
        continue;
      const double cost = thin * (costOf(*sum, leastSurface) + right[b]);
      if (!best || cost < best->cost)
        best = Cut{axis, b, cost};
    }
  }
  return best;
}

/// Where the right child's lights begin.
std::uint32_t LightTreeBuilder::divide(const Range& r, const LightBounds& whole) {
  const std::uint32_t middle = r.begin + r.size() / 2;
  Bins bins;
  for (const std::uint32_t i : lightsOf(r))
    bins.centres.extend(m_lights[i].box.centre());
  // Levels left are kept for halving what is left.
  const auto halvings = static_cast<std::uint32_t>(std::bit_width(r.size() - 1U));
  const auto cut =
      r.depth + halvings < shared::kMaxLightTreeDepth ? cheapestCut(r, bins, whole) : std::nullopt;
  const auto range = lightsOf(r);
  if (!cut) {
    const Vec3d extent = bins.centres.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
    const auto key = [&](std::uint32_t i) { return std::pair(m_lights[i].box.centre()[axis], i); };
    std::ranges::nth_element(range, range.begin() + (middle - r.begin), {}, key);
    return middle;
  }
  const auto rest = std::ranges::stable_partition(
      range, [&](std::uint32_t i) { return bins.of(m_lights[i], cut->axis) < cut->bin; });
  return r.end - static_cast<std::uint32_t>(rest.size());
}

LightTree LightTreeBuilder::build() {
  LightTree tree;
  const auto n = static_cast<std::uint32_t>(m_lights.size());
  assert(n > 0);
  tree.leafOfLight.resize(n);
  tree.nodes.resize(2);
  std::vector<Range> open{{0, n, 0, 0}};
  while (!open.empty()) {
    const Range r = open.back();
    open.pop_back();
    const LightBounds bounds = boundsOf(r);
    tree.nodes[r.node].bounds = bounds;
    if (r.size() == 1) {
      tree.nodes[r.node].leaf = true;
      tree.nodes[r.node].below = m_order[r.begin];
      tree.leafOfLight[m_order[r.begin]] = r.node;
      continue;
    }
    const auto pair = static_cast<std::uint32_t>(tree.nodes.size());
    const std::uint32_t middle = divide(r, bounds);
    tree.nodes[r.node].below = pair;
    tree.nodes.resize(pair + 2U);
    tree.nodes[pair].parent = r.node;
    tree.nodes[pair + 1U].parent = r.node;
    open.push_back({middle, r.end, pair + 1U, r.depth + 1});
    open.push_back({r.begin, middle, pair, r.depth + 1});
  }
  return tree;
}

LightBounds boundsOfLight(const Scene& scene, const LightSource& light, const Box3d& whole) {
  LightBounds b;
  b.power = light.probability;
  switch (light.kind) {
  case LightSource::Kind::Triangle: {
    const Triangle& t = scene.triangles[light.index];
    std::array<Vec3d, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] = scene.positions[t.vertex[i]];
      b.box.extend(v[i]);
    }
    b.axis = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
    break;
  }
  case LightSource::Kind::Point:
    b.box.extend(Vec3d(scene.pointLights[light.index].position));
    b.cosSpread = -1.0;
    break;
  case LightSource::Kind::Directional:
  case LightSource::Kind::Environment:
    b.box = whole;
    b.cosSpread = -1.0;
    break;
  }
  return b;
}

bool areSpread(const Scene& scene, const LightTable& table) {
  constexpr std::size_t kFew = 8;
  constexpr double kSmallPlace = 0.25; // of the scene's size
  if (table.lights.size() < kFew)
    return false;
  const Box3d whole = sceneBox(scene);
  Box3d place;
  for (const LightSource& light : table.lights)
    place.extend(boundsOfLight(scene, light, whole).box);
  return glm::length(place.extent()) > kSmallPlace * glm::length(whole.extent());
}

} // namespace

/// The cone about two cones: they lie in one plane with it.
LightBounds unite(const LightBounds& a, const LightBounds& b) {
  LightBounds u = a;
  u.box.extend(b.box);
  u.power = a.power + b.power;
  if (a.cosSpread <= -1.0)
    return u;
  const double spreadA = angleOf(a.cosSpread);
  const double spreadB = angleOf(b.cosSpread);
  const double between = angleOf(glm::dot(a.axis, b.axis));
  if (std::min(between + spreadB, kPi) <= spreadA)
    return u;
  if (std::min(between + spreadA, kPi) <= spreadB) {
    u.axis = b.axis;
    u.cosSpread = b.cosSpread;
    return u;
  }
  const double spread = 0.5 * (spreadA + between + spreadB);
  const Vec3d across = b.axis - glm::dot(a.axis, b.axis) * a.axis;
  if (spread >= kPi || !(glm::length(across) > 0.0)) {
    u.cosSpread = -1.0;
    return u;
  }
  const double turn = spread - spreadA;
  u.axis = glm::normalize(std::cos(turn) * a.axis + std::sin(turn) * glm::normalize(across));
  u.cosSpread = std::cos(spread);
  return u;
}

bool choosesByTree(const Scene& scene, const EstimatorSettings& settings, const LightTable& table) {
  if (settings.lightSelection == LightSelection::Auto)
    return areSpread(scene, table);
  return settings.lightSelection == LightSelection::Tree && table.lights.size() > 1;
}

LightTree makeLightTree(const Scene& scene, const LightTable& table) {
  const Box3d whole = sceneBox(scene);
  std::vector<LightBounds> lights;
  lights.reserve(table.lights.size());
  for (const LightSource& light : table.lights)
    lights.push_back(boundsOfLight(scene, light, whole));
  LightTree tree = LightTreeBuilder(std::move(lights)).build();
  tree.smallestRadius = whole.empty() ? 1.0 : 1e-6 * glm::length(whole.extent());
  return tree;
}

} // namespace vkpt
