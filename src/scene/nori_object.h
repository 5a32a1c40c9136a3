#pragma once
// A Nori object, such as <bsdf type="diffuse">: its properties by name, and the objects in it.

#include "core/math.h"
#include "scene/nori_xml.h"
#include "scene/scene.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt {

/// What a number must be; `text` completes "give ...".
struct NoriRule {
  std::string_view text;
  bool (*holds)(double);
};
inline constexpr NoriRule kAnyNumber{"any number", [](double) { return true; }};
inline constexpr NoriRule kPositive{"more than 0", [](double x) { return x > 0.0; }};
inline constexpr NoriRule kNotNegative{"0 or more", [](double x) { return x >= 0.0; }};
inline constexpr NoriRule kOneOrMore{"1 or more", [](double x) { return x >= 1.0; }};

/// A property's name has to outlive the object: a literal.
class NoriObject {
public:
  /// `childTags`: the objects that may stand in it. Throws SceneError at an element that may not.
  NoriObject(const XmlElement& element, std::span<const std::string_view> childTags, SceneReport& report);

  [[nodiscard]] const SourceLocation& where() const { return m_element.where; }
  /// Of the property, or of the object where it has none of this name.
  [[nodiscard]] const SourceLocation& where(std::string_view property) const;
  [[nodiscard]] SceneReport& report() const { return m_report; }

  // Each returns nothing (or `fallback`) where there is no such property, and throws SceneError where it has
  // another type or breaks the rule.
  std::optional<double> number(std::string_view name, const NoriRule& rule);
  double number(std::string_view name, const NoriRule& rule, double fallback);
  int integer(std::string_view name, const NoriRule& rule, int fallback);
  std::optional<Vec3d> colour(std::string_view name, const NoriRule& rule);
  Vec3d colour(std::string_view name, const NoriRule& rule, double fallback);
  std::optional<Vec3d> vector(std::string_view name); ///< a point, too
  std::optional<std::string> text(std::string_view name);
  std::optional<glm::dmat4> transform(std::string_view name);

  /// The elements with one of the tags, in the order of the document.
  [[nodiscard]] std::vector<const XmlElement*> children(std::span<const std::string_view> tags) const;
  /// The one element with one of the tags, or nullptr. Throws SceneError at a second one.
  [[nodiscard]] const XmlElement* onlyChild(std::span<const std::string_view> tags) const;

  void warn(const SourceLocation& where, const std::string& what) const;
  /// A warning for each property that nobody has asked for.
  void warnOfUnread() const;

private:
  void addProperty(const XmlElement& property);
  [[noreturn]] void refuseChild(const XmlElement& child, std::span<const std::string_view> childTags) const;
  const XmlElement* ask(std::string_view name, std::span<const std::string_view> tags);
  void check(std::string_view name, const NoriRule& rule, double value) const;
  [[nodiscard]] std::string title() const;

  const XmlElement& m_element;
  SceneReport& m_report;
  std::map<std::string, const XmlElement*, std::less<>> m_properties;
  std::vector<std::string_view> m_asked;
  std::vector<const XmlElement*> m_children;
};

/// The place of the element's type in `types`. Throws SceneError where it is none of them.
std::size_t noriTypeIndex(const XmlElement& element, std::span<const std::string_view> types);

/// The entry of a table whose member `type` is the element's type. Throws SceneError where there is none.
template<class Table>
const auto& noriTypeEntry(const XmlElement& element, const Table& table) {
  std::vector<std::string_view> types;
  std::ranges::transform(table, std::back_inserter(types), [](const auto& entry) { return entry.type; });
  return table[noriTypeIndex(element, types)];
}

} // namespace vkpt
