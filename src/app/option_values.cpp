#include "app/option_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace vkpt {
namespace {

/// The whole of `text`, or nothing.
template<class Number>
std::optional<Number> numberFrom(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

} // namespace

void refuseValue(std::string_view option, std::string_view typed, std::string_view right) {
  throw UsageError(fmt::format("{} '{}': expected {}", option, typed, right));
}

std::uint64_t parseWhole(std::string_view option, std::string_view text, std::uint64_t least,
                         std::uint64_t most) {
  const auto value = numberFrom<std::uint64_t>(text);
  if (!value || *value < least || *value > most)
    refuseValue(option, text, fmt::format("a whole number from {} to {}", least, most));
  return *value;
}

double parseFinite(std::string_view option, std::string_view text, std::string_view right) {
  const auto value = numberFrom<double>(text);
  if (!value || !std::isfinite(*value))
    refuseValue(option, text, right);
  return *value;
}

double parsePositive(std::string_view option, std::string_view text, std::string_view right) {
  const double value = parseFinite(option, text, right);
  if (!(value > 0.0))
    refuseValue(option, text, right);
  return value;
}

std::vector<double> parseList(std::string_view option, std::string_view text, std::size_t count,
                              std::string_view right) {
  std::vector<double> values;
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const auto value = numberFrom<double>(rest.substr(0, comma));
    if (!value || !std::isfinite(*value))
      refuseValue(option, text, right);
    values.push_back(*value);
    more = comma != std::string_view::npos;
    if (more)
      rest.remove_prefix(comma + 1);
  }
  if (values.size() != count)
    refuseValue(option, text, right);
  return values;
}

std::pair<int, int> parseSize(std::string_view option, std::string_view text) {
  const std::size_t x = text.find('x');
  const auto width = numberFrom<int>(text.substr(0, x));
  const auto height = x == std::string_view::npos ? std::nullopt : numberFrom<int>(text.substr(x + 1));
  if (!width || !height || *width < 1 || *height < 1)
    refuseValue(option, text, "WxH with both above 0, e.g. 512x512");
  return {*width, *height};
}

std::size_t parseName(std::string_view option, std::string_view text,
                      std::span<const std::string_view> names) {
  const auto found = std::ranges::find(names, text);
  if (found == names.end())
    refuseValue(option, text, fmt::format("{}", fmt::join(names, " or ")));
  return static_cast<std::size_t>(found - names.begin());
}

} // namespace vkpt
