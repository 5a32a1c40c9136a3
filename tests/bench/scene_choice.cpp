#include "scene_choice.h"

#include "scene/load.h"
#include "scene/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vkpt::bench {
namespace {

constexpr std::uint32_t kMillion = 1'000'000;

Scene loadFiles(const std::vector<fs::path>& files, int size) {
  SceneReport report;
  Scene scene = loadScene(files, report);
  scene.width = scene.height = size;
  return scene;
}

Box3f boxOf(const Scene& scene) {
  Box3f box;
  for (const Vec3f& p : scene.positions)
    box.extend(p);
  return box;
}

std::uint32_t materialNamed(const Scene& scene, std::string_view name) {
  const auto at = std::ranges::find(scene.materials, name, &Material::name);
  return static_cast<std::uint32_t>(at - scene.materials.begin());
}

Vec3f crossOf(const Scene& scene, const Triangle& t) {
  const Vec3f& a = scene.positions[t.vertex[0]];
  return glm::cross(scene.positions[t.vertex[1]] - a, scene.positions[t.vertex[2]] - a);
}

std::uint32_t addVertex(Scene& scene, const Vec3f& p) {
  scene.positions.push_back(p);
  return static_cast<std::uint32_t>(scene.positions.size() - 1);
}

/// Distance of the ball's surface from its middle in the direction d: waves of a few lengths.
float bumps(const Vec3f& d) {
  const float coarse = std::sin(7.0F * d.x) * std::sin(6.0F * d.y + 1.0F) * std::sin(8.0F * d.z + 2.0F);
  const float fine = std::sin(41.0F * d.x + 3.0F) * std::sin(37.0F * d.y) * std::sin(43.0F * d.z + 1.0F);
  return 1.0F + 0.15F * coarse + 0.02F * fine;
}

/// An octahedron whose edges are cut into `n`, blown up.
class Ball {
public:
  Ball(Scene& scene, const Vec3f& middle, float radius, std::uint32_t n)
      : m_scene(scene), m_middle(middle), m_radius(radius), m_n(static_cast<int>(n)) {}

  void add() {
    const std::size_t first = m_scene.triangles.size();
    for (const int x : {-1, 1})
      for (const int y : {-1, 1})
        for (const int z : {-1, 1})
          addFace({x, y, z});
    smooth(first);
  }

private:
  using Corner = std::array<int, 3>; ///< on the octahedron |x| + |y| + |z| = n

  std::uint32_t vertex(const Corner& c) {
    const auto [at, isNew] = m_vertices.try_emplace(c, 0U);
    if (isNew) {
      const Vec3f d = glm::normalize(Vec3f(c[0], c[1], c[2]));
      at->second = addVertex(m_scene, m_middle + m_radius * bumps(d) * d);
    }
    return at->second;
  }
  void addTriangle(const std::array<Corner, 3>& c, bool turned) {
    Triangle t;
    t.material = materialNamed(m_scene, "white");
    t.vertex = {vertex(c[0]), vertex(c[turned ? 2 : 1]), vertex(c[turned ? 1 : 2])};
    m_scene.triangles.push_back(t);
  }
  void addFace(const Corner& sign) {
    const bool turned = sign[0] * sign[1] * sign[2] < 0;
    const auto at = [&](int i, int j) { return Corner{sign[0] * (m_n - i - j), sign[1] * i, sign[2] * j}; };
    for (int i = 0; i < m_n; ++i) {
      for (int j = 0; i + j < m_n; ++j) {
        addTriangle({at(i, j), at(i + 1, j), at(i, j + 1)}, turned);
        if (i + j + 1 < m_n)
          addTriangle({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, turned);
      }
    }
  }
  /// Normals of the ball's own vertices, weighted by area.
  void smooth(std::size_t first) {
    const auto base = static_cast<std::uint32_t>(m_scene.positions.size() - m_vertices.size());
    const auto offset = static_cast<std::uint32_t>(m_scene.normals.size());
    m_scene.normals.resize(offset + m_vertices.size(), Vec3f(0.0F));
    for (std::size_t i = first; i < m_scene.triangles.size(); ++i) {
      Triangle& t = m_scene.triangles[i];
      for (std::size_t c = 0; c < 3; ++c) {
        t.normal[c] = t.vertex[c] - base + offset;
        m_scene.normals[t.normal[c]] += crossOf(m_scene, t);
      }
    }
    for (std::size_t i = offset; i < m_scene.normals.size(); ++i)
      m_scene.normals[i] = glm::normalize(m_scene.normals[i]);
  }

  Scene& m_scene;
  Vec3f m_middle;
  float m_radius;
  int m_n;
  std::map<Corner, std::uint32_t> m_vertices;
};

/// What takes the lamp's place and sends out as much light: rectangles all over the ceiling, two triangles
/// each.
struct Lamps {
  int columns = 1;
  int rows = 1;
  bool touch = false; ///< each other and the walls; otherwise they have the lamp's area together
};

Scene boxWithLamps(const Lamps& lamps, int size) {
  Scene scene = loadFiles({"CornellBox.obj", "CornellBlocks.obj"}, size);
  const std::uint32_t light = materialNamed(scene, "light");
  float area = 0.0F;
  Vec3f facing(0.0F);
  float height = 0.0F;
  std::erase_if(scene.triangles, [&](const Triangle& t) {
    if (t.material != light)
      return false;
    facing = crossOf(scene, t);
    area += 0.5F * glm::length(facing);
    height = scene.positions[t.vertex[0]].y;
    return true;
  });
  const Box3f box = boxOf(scene);
  const Vec3f cell = box.extent() / Vec3f(lamps.columns, 1.0F, lamps.rows);
  const float covered = area / (box.extent().x * box.extent().z);
  const float fill = lamps.touch ? 1.0F : std::sqrt(covered);
  scene.materials.at(light).emission *= covered / (fill * fill);
  for (int i = 0; i < lamps.columns * lamps.rows; ++i) {
    const Vec3f middle = Vec3f(i % lamps.columns, 0.0F, i / lamps.columns) + Vec3f(0.5F, 0.0F, 0.5F);
    const auto corner = [&](float x, float z) {
      const Vec3f p = box.lower + cell * (middle + 0.5F * fill * Vec3f(x, 0.0F, z));
      return addVertex(scene, {p.x, height, p.z});
    };
    const std::array<std::uint32_t, 4> c{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    for (Triangle t : {Triangle{{c[0], c[1], c[2]}}, Triangle{{c[0], c[2], c[3]}}}) {
      t.material = light;
      if (glm::dot(crossOf(scene, t), facing) < 0.0F)
        std::swap(t.vertex[1], t.vertex[2]);
      scene.triangles.push_back(t);
    }
  }
  return scene;
}

void setMaterial(Scene& scene, std::string_view name, BsdfType bsdf, const Vec3f& reflectance,
                 const Vec3f& emission = Vec3f(0.0F)) {
  Material& m = scene.materials.at(materialNamed(scene, name));
  m.bsdf = bsdf;
  m.reflectance = reflectance;
  m.emission = emission;
}

/// Moves what is made of a material, a sphere, to where it is to be.
void moveSphere(Scene& scene, std::string_view material, const Vec3f& centre, float radius) {
  const std::uint32_t id = materialNamed(scene, material);
  std::set<std::uint32_t> vertices;
  for (const Triangle& t : scene.triangles) {
    if (t.material == id)
      vertices.insert(t.vertex.begin(), t.vertex.end());
  }
  Box3f box;
  for (const std::uint32_t v : vertices)
    box.extend(scene.positions[v]);
  const float scale = 2.0F * radius / box.extent().y;
  for (const std::uint32_t v : vertices)
    scene.positions[v] = centre + scale * (scene.positions[v] - box.centre());
}

/// The box as other renderers were measured in it: colours, camera and spheres given in the measured data's
/// millimetres.
Scene peersBox(bool spheres, int size) {
  const std::vector<fs::path> files =
      spheres ? std::vector<fs::path>{"CornellBox.obj", "CornellLeftSphere.obj", "CornellRightSphere.obj"}
              : std::vector<fs::path>{"CornellBox.obj", "CornellBlocks.obj"};
  Scene scene = loadFiles(files, size);
  setMaterial(scene, "white", BsdfType::Diffuse, {0.725F, 0.71F, 0.68F});
  setMaterial(scene, "red", BsdfType::Diffuse, {0.63F, 0.065F, 0.05F});
  setMaterial(scene, "green", BsdfType::Diffuse, {0.14F, 0.45F, 0.091F});
  setMaterial(scene, "light", BsdfType::Diffuse, Vec3f(0.0F), {17.0F, 12.0F, 4.0F});
  const Placement place = placementFor("CornellBox.obj");
  scene.camera = {place.position({278.0, 273.0, -800.0}), place.position({278.0, 273.0, 0.0})};
  scene.camera.fovDegrees = 39.3;
  scene.camera.fovAxis = Camera::FovAxis::Horizontal;
  if (spheres) {
    const auto local = [&](const Vec3d& p) { return Vec3f(place.position(p) - scene.origin); };
    const auto radius = static_cast<float>(100.0 * place.scale);
    setMaterial(scene, "silver", BsdfType::Mirror, Vec3f(0.95F));
    moveSphere(scene, "silver", local({400.0, 100.0, 370.0}), radius);
    moveSphere(scene, "glass", local({155.0, 100.0, 190.0}), radius);
  }
  return scene;
}

} // namespace

Scene boxWithBall(std::uint32_t triangles, int size) {
  Scene scene = loadFiles({"CornellBox.obj"}, size);
  const Box3f box = boxOf(scene);
  const Vec3f extent = box.upper - box.lower;
  const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 8.0)));
  const float radius = 0.36F * extent.y;
  const Vec3f middle(0.5F * (box.lower.x + box.upper.x), box.lower.y + 1.2F * radius,
                     0.5F * (box.lower.z + box.upper.z));
  Ball(scene, middle, radius, std::max(1U, n)).add();
  return scene;
}

Scene loadByName(const std::string& name, int size, const fs::path& mesh) {
  if (name == "blocks")
    return loadFiles({"CornellBox.obj", "CornellBlocks.obj"}, size);
  if (name == "spheres")
    return loadFiles({"CornellBox.obj", "CornellLeftSphere.obj", "CornellRightSphere.obj"}, size);
  if (name == "busts")
    return loadFiles({fs::path(VKPT_SOURCE_DIR) / "assets/busts.xml"}, size);
  if (name == "mesh" && !mesh.empty())
    return loadFiles({"CornellBox.obj", mesh}, size);
  if (name == "million")
    return boxWithBall(kMillion, size);
  if (name == "lights")
    return boxWithLamps({25, 20, false}, size);
  if (name == "ceiling")
    return boxWithLamps({1, 1, true}, size);
  if (name == "tiles")
    return boxWithLamps({25, 20, true}, size);
  if (name == "peers-blocks" || name == "peers-spheres")
    return peersBox(name == "peers-spheres", size);
  if (fs::path(name).has_extension())
    return loadFiles({name}, size);
  throw UsageError(fmt::format("--scenes {}: {}", name, kSceneNames));
}

} // namespace vkpt::bench
