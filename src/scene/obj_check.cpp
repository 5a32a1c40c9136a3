#include "scene/obj_check.h"

#include "scene/names.h"
#include "scene/statements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace vkpt {

namespace {

constexpr std::string_view kForms = "a corner is v, v/t, v//n or v/t/n";

class ObjChecker {
public:
  ObjChecker(const SceneText& source, std::vector<std::string>& warnings)
      : m_source(source), m_warnings(warnings) {}

  std::vector<ObjMaterialUse> run() {
    StatementReader reader(m_source.text);
    while (reader.next(m_statement)) {
      checkStatement();
    }
    if (m_unknownCount > 0) {
      m_warnings.push_back(fmt::format("{}: '{}' is no record that vkpt reads; {} such line{} left out",
                                       m_firstUnknown.text(), m_unknownKey, m_unknownCount,
                                       m_unknownCount == 1 ? "" : "s"));
    }
    return std::move(m_libraries);
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw SceneError({m_source.name, m_statement.line}, what);
  }

  void checkStatement() {
    const std::string_view key = m_statement.key();
    if (key == "v") {
      checkVertex();
    } else if (key == "vn") {
      checkNumbers("a normal needs three numbers, x y z", 3);
    } else if (key == "vt") {
      checkNumbers("a texture coordinate needs one to three numbers", 1);
    } else if (key == "f") {
      checkFace();
    } else if (key == "mtllib") {
      m_libraries.push_back({std::string(m_statement.arguments()), m_statement.line});
    } else {
      checkUnread(key);
    }
  }

  /// Leaves the words of the statement in m_words and their values in m_numbers.
  void checkNumbers(std::string_view need, std::size_t least) {
    splitWords(m_statement.arguments(), m_words);
    m_numbers.clear();
    if (m_words.size() < least) {
      fail(fmt::format("'{}' is cut short; {}", shown(m_statement.text), need));
    }
    for (const std::string_view word : m_words) {
      const auto number = parseNumber(word);
      if (!number) {
        fail(fmt::format("'{}' is no number; {}", shown(word), need));
      }
      m_numbers.push_back(*number);
    }
  }

  void checkVertex() {
    checkNumbers("a vertex needs three numbers, x y z", 3);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!std::isfinite(m_numbers[i])) {
        fail(fmt::format("vertex coordinate '{}' is not finite; give a number", shown(m_words[i])));
      }
      if (std::abs(m_numbers[i]) > kLargestCoordinate) {
        fail(fmt::format("vertex coordinate '{}' is too large; at most {:g}", shown(m_words[i]),
                         kLargestCoordinate));
      }
    }
  }

  void checkFace() {
    splitWords(m_statement.arguments(), m_words);
    if (m_words.size() < 3) {
      fail(fmt::format("a face with {} corner{}; it needs 3 or more", m_words.size(),
                       m_words.size() == 1 ? "" : "s"));
    }
    for (const std::string_view word : m_words) {
      checkCorner(word);
    }
  }

  void checkCorner(std::string_view word) const {
    std::string_view rest = word;
    for (std::size_t part = 0;; ++part) {
      const auto slash = rest.find('/');
      const std::string_view index = rest.substr(0, slash);
      // v//n leaves out t, and so do the endings v/ and v//.
      if (!index.empty() || part == 0) {
        checkIndex(index, word);
      }
      if (slash == std::string_view::npos) {
        return;
      }
      if (part == 2) {
        fail(fmt::format("'{}' has too many parts; {}", shown(word), kForms));
      }
      rest.remove_prefix(slash + 1);
    }
  }

  void checkIndex(std::string_view index, std::string_view word) const {
    const auto value = parseInteger(index);
    if (!value && !index.empty() && index.find_first_not_of("+-0123456789") == std::string_view::npos &&
        index.find_first_of("0123456789") != std::string_view::npos) {
      fail(fmt::format("index {} in '{}' is out of range; indices have at most 31 bits", shown(index),
                       shown(word)));
    }
    if (!value) {
      fail(fmt::format("'{}' in corner '{}' is no index; {}", shown(index), shown(word), kForms));
    }
    if (*value == 0) {
      fail(fmt::format("index 0 in '{}' is out of range; the first is 1, the last before the face -1",
                       shown(word)));
    }
  }

  void checkUnread(std::string_view key) {
    static constexpr std::array<std::string_view, 9> kHarmless{"usemtl", "g",  "o",   "s",     "l",
                                                               "p",      "mg", "lod", "usemap"};
    if (std::ranges::find(kHarmless, key) != kHarmless.end()) {
      return;
    }
    if (m_unknownCount++ == 0) {
      m_firstUnknown = {m_source.name, m_statement.line};
      m_unknownKey = shown(key);
    }
  }

  const SceneText& m_source;
  std::vector<std::string>& m_warnings;
  Statement m_statement;
  std::vector<std::string_view> m_words;
  std::vector<double> m_numbers;
  std::vector<ObjMaterialUse> m_libraries;
  std::size_t m_unknownCount = 0;
  SourceLocation m_firstUnknown;
  std::string m_unknownKey;
};

} // namespace

std::vector<ObjMaterialUse> checkObj(const SceneText& source, std::vector<std::string>& warnings) {
  return ObjChecker(source, warnings).run();
}

} // namespace vkpt
