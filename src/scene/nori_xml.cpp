#include "scene/nori_xml.h"

#include "scene/names.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

namespace vkpt {

namespace {

/// A scene in a test nests six; the tree is walked by recursion.
constexpr int kDeepest = 64;

std::string_view reasonOf(const pugi::xml_parse_result& result) {
  switch (result.status) {
  case pugi::status_end_element_mismatch:
    return "an element is not closed, or another one than the last that was opened; "
           "write </name> or end the tag with />";
  case pugi::status_bad_start_element:
    return "a broken tag; write <name attribute=\"value\"> or <name attribute=\"value\"/>";
  case pugi::status_bad_end_element:
    return "a broken end tag; write </name>";
  case pugi::status_bad_attribute:
    return "a broken attribute; write name=\"value\", with quotes";
  case pugi::status_unrecognized_tag:
    return "'<' is followed by no name; write &lt; where no tag is meant";
  case pugi::status_bad_comment:
    return "a comment is not closed; end it with -->";
  default:
    return result.description();
  }
}

class Parser {
public:
  explicit Parser(const SceneText& source) : m_source(source), m_text(source.text) {
    if (m_text.starts_with("\xFF\xFE") || m_text.starts_with("\xFE\xFF")) {
      throw SceneError({m_source.name}, "is UTF-16; save it as UTF-8");
    }
    if (m_text.starts_with("\xEF\xBB\xBF")) {
      m_text.remove_prefix(3);
    }
    findLines();
  }

  XmlElement run() {
    const auto zero = m_text.find('\0');
    if (zero != std::string_view::npos) {
      throw SceneError(at(zero), "a zero byte; a scene file is text");
    }
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_buffer(
        m_text.data(), m_text.size(), pugi::parse_default | pugi::parse_fragment, pugi::encoding_utf8);
    if (!result) {
      throw SceneError(at(static_cast<std::size_t>(result.offset)),
                       fmt::format("no XML: {}", reasonOf(result)));
    }
    std::vector<XmlElement> roots = children(document, 0);
    if (roots.empty()) {
      throw SceneError({m_source.name}, "no elements; a Nori file is a <scene> or a <test>");
    }
    if (roots.size() > 1) {
      throw SceneError(roots[1].where,
                       fmt::format("a second root element, <{}>; a file has one", shown(roots[1].tag)));
    }
    return std::move(roots.front());
  }

private:
  void findLines() {
    m_lines.push_back(0);
    for (std::size_t i = 0; i < m_text.size(); ++i) {
      if (m_text[i] == '\n' || (m_text[i] == '\r' && (i + 1 == m_text.size() || m_text[i + 1] != '\n'))) {
        m_lines.push_back(i + 1);
      }
    }
  }

  [[nodiscard]] SourceLocation at(std::size_t offset) const {
    const auto next = std::ranges::upper_bound(m_lines, std::min(offset, m_text.size()));
    return {m_source.name, static_cast<std::size_t>(next - m_lines.begin()), offset - *(next - 1) + 1};
  }

  std::vector<XmlElement> children(const pugi::xml_node& parent, int depth) {
    std::vector<XmlElement> elements;
    for (const pugi::xml_node& node : parent.children()) {
      const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
      if (node.type() != pugi::node_element) {
        const std::size_t first = m_text.find_first_not_of(" \t\r\n", offset);
        throw SceneError(at(first),
                         fmt::format("text '{}' between elements; values stand in attributes, "
                                     "remarks in <!-- -->",
                                     shown(m_text.substr(first, m_text.find('<', first) - first))));
      }
      if (depth == kDeepest) {
        throw SceneError(
            at(offset - 1),
            fmt::format("elements in elements, {} deep; a Nori file has at most 6", kDeepest + 1));
      }
      elements.push_back({node.name(), at(offset - 1), {}, {}});
      readAttributes(node, elements.back());
      elements.back().children = children(node, depth + 1);
    }
    return elements;
  }

  static void readAttributes(const pugi::xml_node& node, XmlElement& element) {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      if (element.find(attribute.name()) != nullptr) {
        throw SceneError(element.where, fmt::format("<{}> has two attributes '{}'; keep one",
                                                    shown(element.tag), shown(attribute.name())));
      }
      element.attributes.push_back({attribute.name(), attribute.value()});
    }
  }

  const SceneText& m_source;
  std::string_view m_text;
  std::vector<std::size_t> m_lines; ///< where each starts
};

} // namespace

const std::string* XmlElement::find(std::string_view attribute) const {
  const auto found = std::ranges::find(attributes, attribute, &XmlAttribute::name);
  return found == attributes.end() ? nullptr : &found->value;
}

const std::string& XmlElement::require(std::string_view attribute) const {
  const std::string* value = find(attribute);
  if (value == nullptr) {
    throw SceneError(where, fmt::format("<{}> has no attribute '{}'; give it", shown(tag), attribute));
  }
  return *value;
}

void XmlElement::allowAttributes(std::span<const std::string_view> known) const {
  for (const XmlAttribute& attribute : attributes) {
    if (std::ranges::find(known, attribute.name) == known.end()) {
      throw SceneError(where, fmt::format("<{}> has an unknown attribute '{}'; it has {}{}", shown(tag),
                                          shown(attribute.name), fmt::join(known, ", "),
                                          didYouMean(attribute.name, known)));
    }
  }
}

void XmlElement::forbidChildren() const {
  if (!children.empty()) {
    throw SceneError(children.front().where, fmt::format("<{}> in a <{}>, which holds no elements",
                                                         shown(children.front().tag), shown(tag)));
  }
}

XmlElement parseXml(const SceneText& source) { return Parser(source).run(); }

} // namespace vkpt
