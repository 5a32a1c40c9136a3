#include "scene/recentre.h"

#include "scene/twins.h"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace vkpt {

namespace {

/// ab == cd in exact arithmetic.
bool sameProducts(double a, double b, double c, double d) {
  const double ab = a * b;
  const double cd = c * d;
  return ab == cd && std::fma(a, b, -ab) == std::fma(c, d, -cd);
}

/// Exact for what the renderer gets, the float coordinates, unless the coordinates of one corner are 2^29
/// times those of another and their difference is rounded.
bool hasNoArea(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const Vec3d u = Vec3d(b) - Vec3d(a);
  const Vec3d v = Vec3d(c) - Vec3d(a);
  return sameProducts(u.x, v.y, u.y, v.x) && sameProducts(u.y, v.z, u.z, v.y) &&
         sameProducts(u.z, v.x, u.x, v.z);
}

/// Triangles of one part that have something in common.
struct Tally {
  std::size_t count = 0;
  std::size_t firstLine = 0;

  void add(std::size_t line) {
    if (count++ == 0) {
      firstLine = line;
    }
  }
};

void warn(SceneReport& report, const MeshPart& part, const Tally& tally, std::string_view what) {
  if (tally.count > 0) {
    report.warnings.push_back(
        fmt::format("{}: {} triangle{} {}{}", SourceLocation{part.name, tally.firstLine}.text(), tally.count,
                    tally.count == 1 ? "" : "s", what, tally.count == 1 ? "" : ", the first here"));
  }
}

} // namespace

Box3d recentre(Scene& scene, std::span<const Vec3d> world) {
  Box3d box;
  for (const Vec3d& p : world) {
    box.extend(p);
  }
  scene.origin = box.centre();
  scene.positions.reserve(world.size());
  for (const Vec3d& p : world) {
    scene.positions.emplace_back(p - scene.origin);
  }
  return box;
}

void dropUseless(Scene& scene, std::span<const MeshPart> parts, SceneReport& report) {
  std::vector<Triangle> kept;
  kept.reserve(scene.triangles.size());
  TwinFinder twins(scene);
  for (const MeshPart& part : parts) {
    Tally noArea;
    Tally same;
    Tally otherLook;
    Tally backToBack;
    for (std::size_t i = 0; i < part.lines.size(); ++i) {
      const auto index = static_cast<std::uint32_t>(part.firstTriangle + i);
      const Triangle& t = scene.triangles[index];
      const auto& p = scene.positions;
      if (hasNoArea(p[t.vertex[0]], p[t.vertex[1]], p[t.vertex[2]])) {
        noArea.add(part.lines[i]);
        continue;
      }
      const Twin twin = twins.find(index);
      if (twin == Twin::Same) {
        same.add(part.lines[i]);
      } else if (twin == Twin::OtherLook) {
        otherLook.add(part.lines[i]);
      } else {
        kept.push_back(t);
      }
      if (twin == Twin::BackToBack) {
        backToBack.add(part.lines[i]);
      }
    }
    report.droppedDegenerate += noArea.count;
    report.droppedDuplicates += same.count + otherLook.count;
    warn(report, part, noArea, "of zero area dropped");
    warn(report, part, same, "dropped for being exactly on an earlier one");
    warn(report, part, otherLook, "of another material dropped for being exactly on an earlier one");
    warn(report, part, backToBack,
         "back to back with an earlier one of another material, which is what is seen");
  }
  if (kept.empty()) {
    throw SceneError({parts.front().name}, fmt::format("no faces with an area (all {} triangles have none); "
                                                       "give at least one",
                                                       scene.triangles.size()));
  }
  scene.triangles = std::move(kept);
}

} // namespace vkpt
