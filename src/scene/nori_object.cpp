#include "scene/nori_object.h"

#include "scene/names.h"
#include "scene/nori_transform.h"
#include "scene/nori_values.h"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vkpt {

namespace {

constexpr std::array<std::string_view, 8> kPropertyTags{"boolean", "integer", "float", "string",
                                                        "point",   "vector",  "color", "transform"};
constexpr std::array<std::string_view, 14> kObjectTags{
    "scene", "mesh",       "bsdf",    "luminaire", "emitter", "camera",    "medium",
    "phase", "integrator", "sampler", "rfilter",   "test",    "evaluator", "texture"};
constexpr std::array<std::string_view, 2> kPropertyAttributes{"name", "value"};
constexpr std::array<std::string_view, 2> kObjectAttributes{"type", "name"};

bool contains(std::span<const std::string_view> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

} // namespace

NoriObject::NoriObject(const XmlElement& element, std::span<const std::string_view> childTags,
                       SceneReport& report)
    : m_element(element), m_report(report) {
  element.allowAttributes(kObjectAttributes);
  for (const XmlElement& child : element.children) {
    if (contains(kPropertyTags, child.tag)) {
      addProperty(child);
    } else if (contains(childTags, child.tag)) {
      m_children.push_back(&child);
    } else {
      refuseChild(child, childTags);
    }
  }
}

void NoriObject::addProperty(const XmlElement& property) {
  property.allowAttributes(kPropertyAttributes);
  const std::string& name = property.require("name");
  if (property.tag != "transform") {
    static_cast<void>(property.require("value"));
    property.forbidChildren();
  }
  const auto [slot, isNew] = m_properties.try_emplace(name, &property);
  if (!isNew) {
    warn(property.where, fmt::format("'{}' again, first at line {}; the last one holds", shown(name),
                                     slot->second->where.line));
    slot->second = &property;
  }
}

void NoriObject::refuseChild(const XmlElement& child, std::span<const std::string_view> childTags) const {
  if (child.tag == "medium" || child.tag == "phase") {
    throw SceneError(child.where,
                     fmt::format("<{}>: vkpt renders no participating media; leave it out", child.tag));
  }
  std::vector<std::string_view> known(childTags.begin(), childTags.end());
  known.insert(known.end(), kPropertyTags.begin(), kPropertyTags.end());
  throw SceneError(child.where,
                   fmt::format("{} <{}> in {}, which holds {}{}",
                               contains(kObjectTags, child.tag) ? "misplaced" : "unknown element",
                               shown(child.tag), title(), fmt::join(known, ", "),
                               didYouMean(child.tag, known)));
}

std::string NoriObject::title() const {
  const std::string* type = m_element.find("type");
  return type == nullptr ? fmt::format("<{}>", m_element.tag)
                         : fmt::format("{} '{}'", m_element.tag, shown(*type));
}

const SourceLocation& NoriObject::where(std::string_view property) const {
  const auto found = m_properties.find(property);
  return found == m_properties.end() ? m_element.where : found->second->where;
}

const XmlElement* NoriObject::ask(std::string_view name, std::span<const std::string_view> tags) {
  m_asked.push_back(name);
  const auto found = m_properties.find(name);
  if (found == m_properties.end()) {
    return nullptr;
  }
  const XmlElement& property = *found->second;
  if (!contains(tags, property.tag)) {
    throw SceneError(property.where,
                     fmt::format("{} is given as <{}>; write <{}>", name, property.tag, tags.front()));
  }
  return &property;
}

void NoriObject::check(std::string_view name, const NoriRule& rule, double value) const {
  if (!rule.holds(value)) {
    throw SceneError(where(name), fmt::format("{} is {}; give {}", name, shortNumber(value), rule.text));
  }
}

std::optional<double> NoriObject::number(std::string_view name, const NoriRule& rule) {
  static constexpr std::array<std::string_view, 2> kTags{"float", "integer"};
  const XmlElement* property = ask(name, kTags);
  if (property == nullptr) {
    return std::nullopt;
  }
  const double value = noriNumber(property->require("value"), property->where, name);
  check(name, rule, value);
  return value;
}

double NoriObject::number(std::string_view name, const NoriRule& rule, double fallback) {
  return number(name, rule).value_or(fallback);
}

int NoriObject::integer(std::string_view name, const NoriRule& rule, int fallback) {
  static constexpr std::array<std::string_view, 1> kTags{"integer"};
  const XmlElement* property = ask(name, kTags);
  if (property == nullptr) {
    return fallback;
  }
  const int value = noriInteger(property->require("value"), property->where, name);
  check(name, rule, value);
  return value;
}

std::optional<Vec3d> NoriObject::colour(std::string_view name, const NoriRule& rule) {
  static constexpr std::array<std::string_view, 1> kTags{"color"};
  const XmlElement* property = ask(name, kTags);
  if (property == nullptr) {
    return std::nullopt;
  }
  const Vec3d value = noriTriple(property->require("value"), property->where, name, "r g b");
  for (int channel = 0; channel < 3; ++channel) {
    check(name, rule, value[channel]);
  }
  return value;
}

Vec3d NoriObject::colour(std::string_view name, const NoriRule& rule, double fallback) {
  return colour(name, rule).value_or(Vec3d(fallback));
}

std::optional<Vec3d> NoriObject::vector(std::string_view name) {
  static constexpr std::array<std::string_view, 2> kTags{"vector", "point"};
  const XmlElement* property = ask(name, kTags);
  if (property == nullptr) {
    return std::nullopt;
  }
  return noriTriple(property->require("value"), property->where, name, "x y z");
}

std::optional<std::string> NoriObject::text(std::string_view name) {
  static constexpr std::array<std::string_view, 1> kTags{"string"};
  const XmlElement* property = ask(name, kTags);
  return property == nullptr ? std::nullopt : std::optional(property->require("value"));
}

std::optional<glm::dmat4> NoriObject::transform(std::string_view name) {
  static constexpr std::array<std::string_view, 1> kTags{"transform"};
  const XmlElement* property = ask(name, kTags);
  return property == nullptr ? std::nullopt : std::optional(readTransform(*property));
}

std::vector<const XmlElement*> NoriObject::children(std::span<const std::string_view> tags) const {
  std::vector<const XmlElement*> chosen;
  std::ranges::copy_if(m_children, std::back_inserter(chosen),
                       [&](const XmlElement* child) { return contains(tags, child->tag); });
  return chosen;
}

const XmlElement* NoriObject::onlyChild(std::span<const std::string_view> tags) const {
  const std::vector<const XmlElement*> chosen = children(tags);
  if (chosen.size() > 1) {
    throw SceneError(chosen[1]->where, fmt::format("a second <{}>, the first is at line {}; keep one",
                                                   chosen[1]->tag, chosen[0]->where.line));
  }
  return chosen.empty() ? nullptr : chosen.front();
}

void NoriObject::warn(const SourceLocation& where, const std::string& what) const {
  m_report.warnings.push_back(fmt::format("{}: {}", where.text(), what));
}

void NoriObject::warnOfUnread() const {
  for (const auto& [name, property] : m_properties) {
    if (!contains(m_asked, name)) {
      warn(property->where,
           fmt::format("{} has no property '{}', so it is ignored; it has {}{}", title(), shown(name),
                       m_asked.empty() ? "none" : fmt::format("{}", fmt::join(m_asked, ", ")),
                       didYouMean(name, m_asked)));
    }
  }
}

std::size_t noriTypeIndex(const XmlElement& element, std::span<const std::string_view> types) {
  element.allowAttributes(kObjectAttributes);
  const std::string& type = element.require("type");
  const auto found = std::ranges::find(types, type);
  if (found == types.end()) {
    throw SceneError(element.where,
                     fmt::format("unknown {} type '{}'; vkpt knows {}{}", element.tag, shown(type),
                                 fmt::join(types, ", "), didYouMean(type, types)));
  }
  return static_cast<std::size_t>(found - types.begin());
}

} // namespace vkpt
