#include "scene/polygon.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace vkpt {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Vec3d areaVector(const std::vector<Vec3d>& p, const std::array<std::uint32_t, 3>& t) {
  return 0.5 * glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

/// Every triangle has an area and faces as the polygon does, and together they have its area: with an outline
/// that does not cross itself that is to cover it exactly once.
void expectCovered(const std::vector<Vec3d>& polygon, const char* what) {
  Triangles cut;
  ASSERT_EQ(triangulate(polygon, cut), PolygonKind::Simple) << what;
  EXPECT_EQ(cut.size(), polygon.size() - 2) << what;
  Vec3d whole(0.0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    whole += 0.5 * glm::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  double sum = 0.0;
  for (const auto& t : cut) {
    const Vec3d a = areaVector(polygon, t);
    EXPECT_GT(glm::dot(a, whole), 0.0) << what;
    sum += glm::length(a);
  }
  // Rounding of a few hundred products, relative.
  EXPECT_NEAR(sum, glm::length(whole), 1e-12 * glm::length(whole)) << what;
}

/// Into a plane that no axis lies in, far enough from the origin for its place to matter.
std::vector<Vec3d> tilted(const std::vector<glm::dvec2>& flat) {
  const Vec3d u = glm::normalize(Vec3d(1.0, 2.0, -0.5));
  const Vec3d v = glm::normalize(glm::cross(Vec3d(0.3, -1.0, 0.7), u));
  std::vector<Vec3d> points;
  for (const glm::dvec2& p : flat) {
    points.push_back(Vec3d(-40.0, 30.0, 20.0) + u * p.x + v * p.y);
  }
  return points;
}

TEST(Polygon, ConvexFacesBecomeTheFrameworksFan) {
  const std::vector<Vec3d> quad{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  Triangles cut;
  EXPECT_EQ(triangulate(quad, cut), PolygonKind::Simple);
  EXPECT_EQ(cut, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  std::vector<glm::dvec2> circle;
  for (int i = 0; i < 300; ++i) {
    circle.emplace_back(std::cos(i * 0.02), std::sin(i * 0.02));
  }
  expectCovered(tilted(circle), "300 corners");
  cut.clear();
  triangulate(tilted(circle), cut);
  for (std::uint32_t i = 0; i < cut.size(); ++i) {
    EXPECT_EQ(cut[i], (std::array<std::uint32_t, 3>{0, i + 1, i + 2}));
  }
}

TEST(Polygon, ConcaveFacesAreCoveredExactly) {
  expectCovered(tilted({{0, 0}, {2, 0}, {0.4, 0.4}, {0, 2}}), "arrow, reflex corner 2");
  expectCovered(tilted({{0.4, 0.4}, {0, 2}, {0, 0}, {2, 0}}), "arrow, reflex corner 0");
  expectCovered(tilted({{2, 0}, {0.4, 0.4}, {0, 2}, {0, 0}}), "arrow, reflex corner 1");
  expectCovered(tilted({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}), "U");
  expectCovered(tilted({{0, 0}, {0, 3}, {1, 3}, {1, 1}, {2, 1}, {2, 3}, {3, 3}, {3, 0}}), "U, other winding");
}

TEST(Polygon, RandomStarsAreCoveredExactly) {
  std::mt19937 random(std::hash<std::string>{}("RandomStarsAreCoveredExactly"));
  std::uniform_real_distribution<double> radius(0.1, 1.0);
  for (int n = 5; n < 60; ++n) {
    std::vector<glm::dvec2> star;
    for (int i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      star.push_back(radius(random) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    expectCovered(tilted(star), "star");
  }
}

TEST(Polygon, CornersInTheMiddleOfAnEdgeLoseNoArea) {
  // In coordinates that are exact, so that the corners lie on the edges exactly.
  expectCovered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, "after corner 0");
  expectCovered({{1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}}, "corner 0 itself");
  expectCovered({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}}, "triangle with a corner on its long edge");
}

TEST(Polygon, SlightlyBentQuadKeepsTheFan) {
  const std::vector<Vec3d> wall{{552.8, 0, 0}, {549.6, 0, 559.2}, {556, 548.8, 559.2}, {556, 548.8, 0}};
  Triangles cut;
  EXPECT_EQ(triangulate(wall, cut), PolygonKind::Simple);
  EXPECT_EQ(cut, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Polygon, CrossedAndEndlessOutlinesAreSaid) {
  Triangles cut;
  EXPECT_EQ(triangulate(std::vector<Vec3d>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, cut),
            PolygonKind::Crossed);
  EXPECT_EQ(triangulate(std::vector<Vec3d>(5, Vec3d(1.0)), cut), PolygonKind::Crossed);
  std::vector<Vec3d> comb;
  for (std::size_t i = 0; i <= kMostConcaveCorners; ++i) {
    comb.emplace_back(static_cast<double>(i), i % 2 == 0 ? 0.0 : 1.0, 0.0);
  }
  comb.emplace_back(2000.0, 10000.0, 0.0);
  EXPECT_EQ(triangulate(comb, cut), PolygonKind::TooLarge);
}

} // namespace
} // namespace vkpt
