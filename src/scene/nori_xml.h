#pragma once
// An XML text as a tree of elements that know where they stand. Nothing here knows what a mesh is.

#include "core/error.h"
#include "scene/sources.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt {

struct XmlAttribute {
  std::string name;
  std::string value;
};

struct XmlElement {
  std::string tag;
  SourceLocation where; ///< of its `<`; columns count bytes
  std::vector<XmlAttribute> attributes;
  std::vector<XmlElement> children;

  /// The attribute's value, or nullptr.
  [[nodiscard]] const std::string* find(std::string_view attribute) const;
  /// The attribute's value. Throws SceneError where there is none.
  [[nodiscard]] const std::string& require(std::string_view attribute) const;
  /// Throws SceneError at an attribute that is not among `known`.
  void allowAttributes(std::span<const std::string_view> known) const;
  /// Throws SceneError where there are children.
  void forbidChildren() const;
};

/// The root element. Throws SceneError with line and column where the text is no XML, where text stands
/// between elements (Nori has none) and where elements are nested absurdly deep. Entities of a DTD are not
/// expanded.
XmlElement parseXml(const SceneText& source);

} // namespace vkpt
