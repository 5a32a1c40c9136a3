#include "scene/obj_reader.h"

#include "scene/obj_check.h"
#include "scene/statements.h"
#include "scene/tinyobj.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <span>
#include <unordered_map>

#include <fmt/format.h>

namespace vkpt {

namespace {

namespace tiny = ::vkpt_tinyobj;

static_assert(kNoNormal == kNoUv, "both are what a corner leaves out");

/// What an index counts, for messages.
struct Kind {
  std::string_view one;
  std::string_view many;
};
constexpr Kind kVertex{"vertex", "vertices"};
constexpr Kind kNormal{"normal", "normals"};
constexpr Kind kTexcoord{"texture coordinate", "texture coordinates"};

/// What the callbacks of tinyobjloader fill.
class ObjBuilder {
public:
  explicit ObjBuilder(const SceneText& source) : m_source(source), m_buffer(source.text) {
    m_mesh.materials.push_back({});
  }

  ObjMesh run(std::vector<std::string>& warnings) {
    m_mesh.libraries = checkObj(m_source, warnings);
    tiny::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, double x, double y, double z, double) {
      static_cast<ObjBuilder*>(self)->m_mesh.positions.emplace_back(x, y, z);
    };
    callbacks.normal_cb = [](void* self, double x, double y, double z) {
      static_cast<ObjBuilder*>(self)->addNormal({x, y, z});
    };
    callbacks.texcoord_cb = [](void* self, double u, double v, double) {
      static_cast<ObjBuilder*>(self)->addUv(u, v);
    };
    callbacks.index_cb = [](void* self, tiny::index_t* indices, int count) {
      static_cast<ObjBuilder*>(self)->addFace({indices, static_cast<std::size_t>(count)});
    };
    callbacks.usemtl_cb = [](void* self, const char* name, int) {
      static_cast<ObjBuilder*>(self)->useMaterial(name);
    };
    std::istream stream(&m_buffer);
    // An exception thrown while a line is handed over is to arrive here.
    stream.exceptions(std::ios::badbit);
    tiny::LoadObjWithCallback(stream, callbacks, this);
    checkRanges();
    warn(warnings, m_badNormals, "normal",
         "zero or not finite, the first here; faces with them get their geometric normal");
    warn(warnings, m_badUvs, "texture coordinate",
         "not finite or beyond the range of float, the first here; taken as 0 0");
    return std::move(m_mesh);
  }

private:
  /// Values that no face can use.
  struct Bad {
    std::size_t count = 0;
    std::size_t firstLine = 0;

    void add(std::size_t line) {
      if (count++ == 0) {
        firstLine = line;
      }
    }
  };

  void warn(std::vector<std::string>& warnings, const Bad& bad, std::string_view one, std::string_view what) {
    if (bad.count > 0) {
      warnings.push_back(fmt::format("{}: {} {}{} {}", SourceLocation{m_source.name, bad.firstLine}.text(),
                                     bad.count, one, bad.count == 1 ? " is" : "s are", what));
    }
  }

  [[nodiscard]] std::size_t line() const { return m_buffer.current().line; }

  /// tinyobjloader reads `nan` and `inf` as 0.
  [[nodiscard]] bool namesNoNumber() const {
    return m_buffer.current().arguments().find_first_of("nNiI") != std::string_view::npos;
  }

  void addUv(double u, double v) {
    const bool good = !namesNoNumber() && std::max(std::abs(u), std::abs(v)) <= kLargestCoordinate;
    if (!good) {
      m_badUvs.add(line());
    }
    m_mesh.uvs.push_back(good ? Vec2f(u, v) : Vec2f(0.0F));
  }

  void addNormal(const Vec3d& n) {
    const double length = glm::length(n);
    const bool good = !namesNoNumber() && length > 0.0 && std::isfinite(length);
    if (!good) {
      m_badNormals.add(line());
    }
    m_mesh.normals.push_back(good ? n / length : Vec3d(0.0));
  }

  /// OBJ counts from 1, and from -1 backwards; 0 is tinyobjloader's "left out": kNoNormal, kNoUv.
  std::uint32_t resolve(int index, std::size_t count, const Kind& kind) const {
    if (index == 0) {
      return kNoNormal;
    }
    if (index > 0) {
      return static_cast<std::uint32_t>(index - 1);
    }
    const auto back = static_cast<std::size_t>(-static_cast<std::int64_t>(index));
    if (back > count) {
      throw SceneError(
          {m_source.name, line()},
          fmt::format("{} index {} is out of range; {} {} above it", kind.one, index, count,
                      count == 1 ? std::string(kind.one) + " stands" : std::string(kind.many) + " stand"));
    }
    return static_cast<std::uint32_t>(count - back);
  }

  void addFace(std::span<const tiny::index_t> indices) {
    m_mesh.faces.push_back({m_mesh.corners.size(), static_cast<std::uint32_t>(indices.size()), m_material,
                            static_cast<std::uint32_t>(line())});
    for (const tiny::index_t& i : indices) {
      m_mesh.corners.push_back({resolve(i.vertex_index, m_mesh.positions.size(), kVertex),
                                resolve(i.normal_index, m_mesh.normals.size(), kNormal),
                                resolve(i.texcoord_index, m_mesh.uvs.size(), kTexcoord)});
    }
  }

  void useMaterial(const char* name) {
    const auto next = static_cast<std::uint32_t>(m_mesh.materials.size());
    const auto [slot, isNew] = m_slots.emplace(name, next);
    if (isNew) {
      m_mesh.materials.push_back({name, line()});
    }
    m_material = slot->second;
  }

  /// Positive indices may point forward, so they are checked when all is known.
  void checkRanges() const {
    for (const ObjFace& face : m_mesh.faces) {
      for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
        const ObjCorner& corner = m_mesh.corners[face.firstCorner + i];
        checkRange(corner.vertex, m_mesh.positions.size(), kVertex, face.line);
        if (corner.normal != kNoNormal) {
          checkRange(corner.normal, m_mesh.normals.size(), kNormal, face.line);
        }
        if (corner.uv != kNoUv) {
          checkRange(corner.uv, m_mesh.uvs.size(), kTexcoord, face.line);
        }
      }
    }
    if (m_mesh.faces.empty()) {
      throw SceneError({m_source.name}, fmt::format("no faces ({} vertices); give at least one 'f' line",
                                                    m_mesh.positions.size()));
    }
  }

  void checkRange(std::uint32_t index, std::size_t count, const Kind& kind, std::size_t where) const {
    if (index >= count) {
      throw SceneError({m_source.name, where},
                       fmt::format("{} index {} is out of range; the file has {} {}", kind.one, index + 1ULL,
                                   count, count == 1 ? kind.one : kind.many));
    }
  }

  const SceneText& m_source;
  StatementBuffer m_buffer;
  ObjMesh m_mesh;
  std::unordered_map<std::string, std::uint32_t> m_slots;
  std::uint32_t m_material = 0;
  Bad m_badNormals;
  Bad m_badUvs;
};

} // namespace

ObjMesh readObj(const SceneText& source, std::vector<std::string>& warnings) {
  return ObjBuilder(source).run(warnings);
}

} // namespace vkpt
