#include "unit/accel/meshes.h"

#include "core/hash.h"

#include <cmath>
#include <numbers>

namespace vkpt::test {

Random::Random(std::string_view name) : m_engine(static_cast<std::uint32_t>(hashText(name))) {}

float Random::uniform(float from, float to) {
  const auto unit = static_cast<float>(m_engine() >> 8U) * 0x1p-24F;
  return from + (to - from) * unit;
}

Vec3f Random::direction() {
  const float z = uniform(-1.0F, 1.0F);
  const float phi = uniform(0.0F, 2.0F * std::numbers::pi_v<float>);
  const float r = std::sqrt(1.0F - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

Mesh soup(std::size_t count, float size, std::string_view seed) {
  Random random(seed);
  Mesh mesh(count);
  for (Triangle& t : mesh) {
    const Vec3f centre = random.inBox(-1.0F, 1.0F);
    for (Vec3f& v : t)
      v = centre + random.inBox(-size, size);
  }
  return mesh;
}

namespace {

template<class Height>
Mesh grid(std::uint32_t n, const Height& height) {
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    const float x = 2.0F * static_cast<float>(i) / static_cast<float>(n) - 1.0F;
    const float z = 2.0F * static_cast<float>(j) / static_cast<float>(n) - 1.0F;
    return Vec3f(x, height(x, z), z);
  };
  Mesh mesh;
  mesh.reserve(std::size_t{2} * n * n);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      mesh.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

} // namespace

Mesh waves(std::uint32_t n) {
  return grid(n, [](float x, float z) {
    return 0.3F * std::sin(9.0F * x) * std::cos(7.0F * z) + 0.5F * std::exp(-20.0F * (x * x + z * z));
  });
}

Mesh flatGrid(std::uint32_t n) {
  return grid(n, [](float, float) { return 0.25F; });
}

Mesh sliverFan(std::size_t count) {
  Mesh mesh(count);
  const auto rim = [&](std::size_t i) {
    const double phi = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    return Vec3f(static_cast<float>(std::cos(phi)), static_cast<float>(std::sin(phi)), 0.1F);
  };
  for (std::size_t i = 0; i < count; ++i)
    mesh[i] = {Vec3f(0.0F), rim(i), rim(i + 1)};
  return mesh;
}

Mesh needles(std::size_t count, std::string_view seed) {
  Random random(seed);
  Mesh mesh(count);
  for (Triangle& t : mesh) {
    const Vec3f from = random.inBox(-1.0F, 1.0F);
    const Vec3f along = random.direction();
    t = {from, from + along, from + 0.5F * along + random.inBox(-1e-3F, 1e-3F)};
  }
  return mesh;
}

Mesh coincident(std::size_t count) {
  return Mesh(count, Triangle{Vec3f(-0.5F, -0.4F, 0.1F), Vec3f(0.6F, -0.3F, 0.2F), Vec3f(0.0F, 0.7F, -0.3F)});
}

Mesh concentric(std::size_t count) {
  Mesh mesh(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float r = static_cast<float>(i + 1) / static_cast<float>(count);
    mesh[i] = {Vec3f(-r, -r, -r), Vec3f(r, r, -r), Vec3f(0.0F, -r, r)};
  }
  return mesh;
}

Mesh geometric(std::size_t count, double ratio) {
  Mesh mesh(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto s = static_cast<float>(std::pow(ratio, static_cast<double>(i)));
    mesh[i] = {Vec3f(s, 0.0F, 0.0F), Vec3f(2.0F * s, s, 0.0F), Vec3f(s, 0.0F, s)};
  }
  return mesh;
}

Mesh onLine(std::size_t count) {
  Mesh mesh(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    mesh[i] = {Vec3f(x, 0.0F, 0.0F), Vec3f(x + 1.0F, 0.0F, 0.0F), Vec3f(x + 0.5F, 0.0F, 0.0F)};
  }
  return mesh;
}

Mesh scaled(Mesh mesh, float factor) {
  for (Triangle& t : mesh) {
    for (Vec3f& v : t)
      v *= factor;
  }
  return mesh;
}

Mesh together(const Mesh& a, const Mesh& b) {
  Mesh mesh = a;
  mesh.insert(mesh.end(), b.begin(), b.end());
  return mesh;
}

std::vector<Box3f> boxesOf(const Mesh& mesh) {
  std::vector<Box3f> boxes(mesh.size());
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    for (const Vec3f& v : mesh[i])
      boxes[i].extend(v);
  }
  return boxes;
}

std::vector<NamedMesh> allKinds() {
  return {
      {"soup", soup(3000, 0.05F, "soup")},
      {"dense soup", soup(2000, 1.0F, "dense soup")},
      {"waves", waves(40)},
      {"flat grid", flatGrid(40)},
      {"sliver fan", sliverFan(3000)},
      {"needles", needles(3000, "needles")},
      {"coincident", coincident(3001)},
      {"concentric", concentric(3000)},
      {"geometric", geometric(240, 0.5)},
      {"geometric, slowly", geometric(5000, 1.015)},
      {"line", onLine(3000)},
      {"soup of size 1e18", scaled(soup(2000, 0.1F, "huge"), 1e18F)},
      {"soup of the largest floats", scaled(soup(2000, 0.1F, "largest"), 3e38F)},
      {"soup of denormal size", scaled(soup(2000, 0.1F, "denormal"), 1e-42F)},
      {"soup and a far speck",
       together(soup(2000, 0.1F, "speck"), scaled(soup(2000, 0.1F, "speck 2"), 1e-6F))},
  };
}

} // namespace vkpt::test
