// Triangles and traversal in float, as the device does them. Literals are float here unless suffixed.

#include "host/program32.h"
#include "unit/host/mesh_scene.h"
#include "unit/host/random.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace vkpt::host32 {
namespace {

using Library = Program<RuntimeEffects>;
using test::Corners;

/// A library over a mesh.
struct Stage {
  explicit Stage(std::span<const Corners> triangles)
      : scene(test::packTriangles(triangles)),
        lib(scene, FrameConstants{}, EffectSet{}, RouletteMode::Throughput) {}
  PackedScene scene;
  Library lib;
};

Library::Ray makeRay(const Vec3d& o, const Vec3d& through) {
  Library::Ray ray;
  ray.o = Vec3(o);
  ray.d = Vec3(glm::normalize(through - Vec3d(ray.o)));
  ray.exclude = Library::kNoTriangle;
  return ray;
}

std::vector<Corners> soup(test::Random& random, int count, double size) {
  std::vector<Corners> triangles;
  for (int i = 0; i < count; ++i) {
    const Vec3 centre = random.inCube<Vec3>();
    triangles.push_back({centre + random.inCube<Vec3>(size), centre + random.inCube<Vec3>(size),
                         centre + random.inCube<Vec3>(size)});
  }
  return triangles;
}

/// Moeller and Trumbore 1997, in double. Returns the least barycentric coordinate (negative: a miss).
double referenceHit(const Library::Ray& ray, const Corners& c, double& t, Vec3d& b) {
  const Vec3d o(ray.o);
  const Vec3d d(ray.d);
  const Vec3d e1 = Vec3d(c[1]) - Vec3d(c[0]);
  const Vec3d e2 = Vec3d(c[2]) - Vec3d(c[0]);
  const Vec3d p = glm::cross(d, e2);
  const double det = glm::dot(e1, p);
  const Vec3d s = o - Vec3d(c[0]);
  const Vec3d q = glm::cross(s, e1);
  b.y = glm::dot(s, p) / det;
  b.z = glm::dot(d, q) / det;
  b.x = 1 - b.y - b.z;
  t = glm::dot(e2, q) / det;
  return std::min(b.x, std::min(b.y, b.z));
}

TEST(HostTriangle, AgreesWithDouble) {
  test::Random random;
  Stage stage(std::vector<Corners>{soup(random, 1, 1)});
  int hits = 0;
  int misses = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const Corners c{random.inCube<Vec3>(), random.inCube<Vec3>(), random.inCube<Vec3>()};
    const Library::Ray ray = makeRay(random.inCube<Vec3d>(3), random.inCube<Vec3d>());
    const Vec3d n = glm::cross(Vec3d(c[1]) - Vec3d(c[0]), Vec3d(c[2]) - Vec3d(c[0]));
    const double projected = std::abs(glm::dot(n, Vec3d(ray.d))); // twice the area the ray sees
    if (projected < static_cast<double>(0.01L))
      continue; // too slim for a tolerance
    double t = 0;
    Vec3d b;
    const double inside = referenceHit(ray, c, t, b);
    // Coordinates up to 6 (origin and corner), each with a few roundings, in products of two, over the area.
    const double tolerance = 64 * 36 * static_cast<double>(kEpsilon) / projected;
    if (std::abs(inside) < tolerance || std::abs(t) < tolerance)
      continue; // too close to call
    Float t32 = 0;
    Float b1 = 0;
    Float b2 = 0;
    const bool hit =
        stage.lib.intersectTriangle(ray, stage.lib.makeRayBasis(ray.d), c[0], c[1], c[2], t32, b1, b2);
    ASSERT_EQ(hit, inside > 0 && t > 0);
    if (hit) {
      ASSERT_NEAR(static_cast<double>(b1), b.y, tolerance);
      ASSERT_NEAR(static_cast<double>(b2), b.z, tolerance);
      ASSERT_NEAR(static_cast<double>(t32), t, 8 * tolerance); // a mean of three distances up to 6
    }
    ++(hit ? hits : misses);
  }
  EXPECT_GT(hits, 50'000);
  EXPECT_GT(misses, 50'000);
}

/// A fan about a vertex at `offset`, and no two points of it behind one another for rays from far above.
std::vector<Corners> fan(test::Random& random, const Vec3d& offset, std::vector<Vec3f>& ring) {
  const int spokes = 5 + static_cast<int>(random.bits() % 10); // no gap of half a turn
  ring.clear();
  for (int i = 0; i < spokes; ++i) {
    const double angle =
        (i + random.between(0, static_cast<double>(0.8L))) * 2 * std::numbers::pi_v<double> / spokes;
    const double radius = random.between(static_cast<double>(0.2L), 1);
    ring.emplace_back(Vec3d(radius * std::cos(angle), radius * std::sin(angle),
                            random.between(0, static_cast<double>(0.1L))) +
                      offset);
  }
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < ring.size(); ++i)
    triangles.push_back({Vec3f(offset), ring[i], ring[(i + 1) % ring.size()]});
  return triangles;
}

TEST(HostTriangle, NoRaySlipsThroughSharedEdgesAndVertices) { // W2
  test::Random random;
  int missed = 0;
  for (int mesh = 0; mesh < 2000; ++mesh) {
    const Vec3d offset = mesh % 2 == 0 ? Vec3d(0) : random.inCube<Vec3d>(1000);
    std::vector<Vec3f> ring;
    Stage stage(fan(random, offset, ring));
    const Vec3d centre{Vec3f(offset)}; // the vertex as the mesh has it
    for (int i = 0; i < 500; ++i) {
      const Vec3d eye = centre + Vec3d(random.between(-1, 1), random.between(-1, 1), random.between(10, 20));
      const Vec3d spoke(ring[random.bits() % ring.size()]);
      const double along = i % 2 == 0 ? 0 : random.between(0, static_cast<double>(0.99L));
      const Library::Ray ray = makeRay(eye, centre + (spoke - centre) * along);
      missed += stage.lib.traceClosest(ray).triangle == Library::kNoTriangle ? 1 : 0;
      missed += stage.lib.traceOccluded(ray, 100, Library::kNoTriangle) ? 0 : 1;
    }
  }
  EXPECT_EQ(missed, 0);
}

/// Corners on a line, and the ray for which another renderer found a hit (pbrt's shapes_test.cpp, BadCases).
/// The loaders drop such a triangle; where one is left, it takes aim to hit it.
TEST(HostTriangle, CornersOnALineAreNotHitFromFarOff) { // W5
  const Corners c{Vec3(-1113.45459, -79.049614, -56.2431908), Vec3(-1113.45459, -87.0922699, -56.2431908),
                  Vec3(-1113.45459, -79.2090149, -56.2431908)};
  Stage stage(std::vector<Corners>{c});
  const Vec3d eye(-1081.47925L, 99.9999542L, 87.7701111L);
  const Vec3d along(-32.1072998L, -183.355865L, -144.607635L);
  EXPECT_EQ(stage.lib.traceClosest(makeRay(eye, eye + along)).triangle, Library::kNoTriangle);
}

/// Every triangle tried, ties to the lower id: what the traversal must find.
Library::Hit bruteForce(Library& lib, std::size_t triangles, const Library::Ray& ray) {
  Library::Hit hit;
  hit.t = Library::kFarAway;
  hit.triangle = Library::kNoTriangle;
  hit.id = Library::kNoTriangle;
  const auto basis = lib.makeRayBasis(ray.d);
  for (uint i = 0; i < triangles; ++i) {
    const auto tri = lib.triangleRecord(i);
    Float t = 0;
    Float b1 = 0;
    Float b2 = 0;
    if (i != ray.exclude && lib.intersectTriangle(ray, basis, tri.v0, tri.v1, tri.v2, t, b1, b2) &&
        (t < hit.t || (t == hit.t && tri.id < hit.id)))
      hit = {t, b1, b2, i, tri.id};
  }
  return hit;
}

TEST(HostTraversal, FindsWhatBruteForceFinds) {
  test::Random random;
  for (const int count : {1, 2, 5, 50, 500}) {
    Stage stage(soup(random, count, static_cast<double>(0.3L)));
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
      Library::Ray ray = makeRay(random.inCube<Vec3d>(2), random.inCube<Vec3d>());
      if (i % 16 == 0) // along an axis: a component of 0 in the slab test
        ray.d = Vec3(i % 3 == 0 ? 1 : 0, i % 3 == 1 ? -1 : 0, i % 3 == 2 ? 1 : 0);
      if (i % 5 == 0)
        ray.exclude = random.bits() % static_cast<uint>(count);
      const auto expected = bruteForce(stage.lib, static_cast<std::size_t>(count), ray);
      const auto hit = stage.lib.traceClosest(ray);
      ASSERT_EQ(hit.triangle, expected.triangle) << count << " triangles, ray " << i;
      ASSERT_EQ(hit.t, expected.t);
      const bool found = expected.triangle != Library::kNoTriangle;
      ASSERT_EQ(stage.lib.traceOccluded(ray, Library::kFarAway, Library::kNoTriangle), found);
      if (found) { // neither what lies behind the end, nor the end itself, nor the target
        ASSERT_FALSE(stage.lib.traceOccluded(ray, hit.t, Library::kNoTriangle));
        ASSERT_TRUE(
            stage.lib.traceOccluded(ray, std::nextafter(hit.t, Library::kFarAway), Library::kNoTriangle));
        ASSERT_FALSE(stage.lib.traceOccluded(ray, std::nextafter(hit.t, Library::kFarAway), hit.triangle));
        ++hits;
      }
    }
    EXPECT_GT(hits, 20);
    EXPECT_EQ(stage.lib.counters.cutTraversal, 0U);
  }
}

TEST(HostTraversal, TiesGoToTheLowerId) {
  test::Random random;
  std::vector<Corners> triangles = soup(random, 20, 1);
  const std::size_t count = triangles.size();
  for (std::size_t i = 0; i < count; ++i) // each twice, last in the list first
    triangles.push_back(triangles[count - 1 - i]);
  Stage stage(triangles);
  int hits = 0;
  for (int i = 0; i < 10'000; ++i) {
    const auto hit = stage.lib.traceClosest(makeRay(random.inCube<Vec3d>(3), random.inCube<Vec3d>()));
    if (hit.triangle == Library::kNoTriangle)
      continue;
    ASSERT_LT(hit.id, count);
    ++hits;
  }
  EXPECT_GT(hits, 1000);
}

} // namespace
} // namespace vkpt::host32
