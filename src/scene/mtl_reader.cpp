#include "scene/mtl_reader.h"

#include "scene/limits.h"
#include "scene/names.h"
#include "scene/statements.h"
#include "scene/texture_arguments.h"
#include "scene/tinyobj.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <fmt/format.h>

namespace vkpt {

namespace {

namespace tiny = ::vkpt_tinyobj;

Vec3d vectorOf(const double (&values)[3]) { return {values[0], values[1], values[2]}; }

/// Looks at every statement: what is malformed ends it, what is fit to be read is handed to tinyobjloader.
/// From here come the line of each material and which keys it gives, neither of which tinyobjloader tells.
class MtlScanner {
public:
  MtlScanner(const SceneText& source, std::vector<std::string>& warnings)
      : m_source(source), m_warnings(warnings) {}

  std::vector<MtlMaterial> run() {
    StatementReader reader(m_source.text);
    while (reader.next(m_statement)) {
      scanStatement();
    }
    if (m_materials.empty()) {
      return {};
    }
    std::map<std::string, int> names;
    std::vector<tiny::material_t> values;
    std::istringstream stream(m_fit);
    std::string ignored;
    tiny::LoadMtl(&names, &values, &stream, &ignored, &ignored);
    for (std::size_t i = 0; i < m_materials.size(); ++i) {
      fill(m_materials[i], values.at(i));
    }
    return std::move(m_materials);
  }

private:
  [[nodiscard]] SourceLocation here() const { return {m_source.name, m_statement.line}; }
  [[noreturn]] void fail(const std::string& what) const { throw SceneError(here(), what); }

  void scanStatement() {
    const std::string_view name = m_statement.key();
    const MtlKey* key = findMtlKey(name);
    if (name == "newmtl") {
      startMaterial();
    } else if (m_materials.empty()) {
      m_warnings.push_back(
          fmt::format("{}: '{}' before the first newmtl is left out", here().text(), shown(name)));
    } else if (key == nullptr) {
      leaveOut(std::string(name), fmt::format("'{}' is no MTL key that vkpt knows; left out", shown(name)));
    } else if (key->use == MtlUse::Read) {
      scanRead(*key);
    } else if (key->use == MtlUse::Ignored && !isNeutral(*key)) {
      leaveOut(std::string(name), fmt::format("{} ({}): {}", name, key->meaning, key->mapping));
    }
  }

  void leaveOut(std::string name, std::string warning) {
    m_materials.back().unread.push_back({std::move(name), std::move(warning), m_statement.line});
  }

  void startMaterial() {
    const std::string name(m_statement.arguments());
    if (name.empty()) {
      fail("newmtl without a name; give one");
    }
    if (std::ranges::find(m_materials, name, &MtlMaterial::name) != m_materials.end()) {
      m_warnings.push_back(fmt::format("{}: material '{}' is defined again; the first one is used",
                                       here().text(), shown(name)));
    }
    m_materials.push_back({});
    m_materials.back().name = name;
    m_materials.back().where = here();
    m_fit.append("newmtl ").append(name).append(1, '\n');
  }

  void scanRead(const MtlKey& key) {
    if (key.value == MtlValue::Text) {
      scanTexture(key);
      return;
    }
    splitWords(m_statement.arguments(), m_words);
    if (key.value == MtlValue::Integer) {
      scanIllum();
      return;
    }
    // By the MTL format a colour of one number is grey; tinyobjloader would make it red.
    const bool grey = key.value == MtlValue::Colour && m_words.size() == 1;
    const std::size_t need = key.value == MtlValue::Colour && !grey ? 3 : 1;
    if (m_words.size() < need) {
      fail(fmt::format("'{}' is cut short; {} needs {}", shown(m_statement.text), key.key,
                       key.value == MtlValue::Colour ? "three numbers, r g b" : "a number"));
    }
    m_fit.append(key.key);
    for (std::size_t i = 0; i < need; ++i) {
      checkValue(key, m_words[i]);
      m_fit.append(1, ' ').append(m_words[i]);
    }
    if (grey) {
      m_fit.append(1, ' ').append(m_words[0]).append(1, ' ').append(m_words[0]);
    }
    m_fit.append(1, '\n');
    note(key.key);
  }

  void scanTexture(const MtlKey& key) {
    TextureArguments arguments = parseTextureArguments(m_statement.arguments());
    for (const std::string_view option : arguments.unusedOptions) {
      const std::string name = fmt::format("{} {}", key.key, option);
      leaveOut(name, fmt::format("{}: this option is not used", name));
    }
    if (arguments.file.empty()) {
      leaveOut(std::string(key.key), fmt::format("{} names no file; left out", key.key));
      return;
    }
    m_materials.back().mapKd = {std::move(arguments.file), m_source.folder, here()};
  }

  void scanIllum() {
    const auto illum = m_words.empty() ? std::nullopt : parseInteger(m_words[0]);
    if (!illum) {
      fail(fmt::format("'{}' is no illumination model; give its number, e.g. illum 1",
                       shown(m_statement.text)));
    }
    m_fit.append(fmt::format("illum {}\n", *illum));
    note("illum");
  }

  void checkValue(const MtlKey& key, std::string_view word) const {
    const auto value = parseNumber(word);
    if (!value) {
      fail(fmt::format("'{}' is no number; {} needs {}", shown(word), key.key,
                       key.value == MtlValue::Colour ? "three numbers, r g b" : "a number"));
    }
    if (!std::isfinite(*value)) {
      fail(fmt::format("{} is '{}', which is not finite; give a number", key.key, shown(word)));
    }
    // Of a number (Ni, Ns) the shader decides: silver's files give one that means nothing, others a 0.
    if (key.value == MtlValue::Colour && *value < 0.0) {
      fail(fmt::format("{} is negative ({}); give 0 or above", key.key, shown(word)));
    }
    if (key.value == MtlValue::Colour && *value > kLargestColour) {
      fail(fmt::format("{} is {}, beyond the range of float; at most {:g}", key.key, shown(word),
                       kLargestColour));
    }
  }

  bool isNeutral(const MtlKey& key) {
    splitWords(m_statement.arguments(), m_words);
    return key.neutral && std::ranges::all_of(m_words, [&](std::string_view word) {
             return parseNumber(word) == key.neutral;
           });
  }

  /// Marks a key as given; `fill` puts the value there.
  void note(std::string_view key) {
    MtlMaterial& m = m_materials.back();
    if (key == "Kd") {
      m.kd.emplace();
    } else if (key == "Ks") {
      m.ks.emplace();
    } else if (key == "Ka") {
      m.ka.emplace();
      m.kaLine = m_statement.line;
    } else if (key == "Ke") {
      m.ke.emplace();
    } else if (key == "Ni") {
      m.ni.emplace();
      m.niLine = m_statement.line;
    } else if (key == "Ns") {
      m.ns.emplace();
      m.nsLine = m_statement.line;
    } else if (key == "illum") {
      m.illum.emplace();
      m.illumLine = m_statement.line;
    }
  }

  static void fill(MtlMaterial& m, const tiny::material_t& values) {
    const auto take = [](std::optional<Vec3d>& to, const Vec3d& value) {
      if (to) {
        to = value;
      }
    };
    take(m.kd, vectorOf(values.diffuse));
    take(m.ks, vectorOf(values.specular));
    take(m.ka, vectorOf(values.ambient));
    take(m.ke, vectorOf(values.emission));
    if (m.ni) {
      m.ni = values.ior;
    }
    if (m.ns) {
      m.ns = values.shininess;
    }
    if (m.illum) {
      m.illum = values.illum;
    }
  }

  const SceneText& m_source;
  std::vector<std::string>& m_warnings;
  Statement m_statement;
  std::vector<std::string_view> m_words;
  std::vector<MtlMaterial> m_materials;
  std::string m_fit; ///< the statements for tinyobjloader
};

} // namespace

std::vector<MtlMaterial> readMtl(const SceneText& source, std::vector<std::string>& warnings) {
  return MtlScanner(source, warnings).run();
}

} // namespace vkpt
