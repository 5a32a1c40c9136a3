#include "scene/nori_values.h"

#include "scene/names.h"
#include "scene/statements.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace vkpt {

namespace {

constexpr std::string_view kSeparators = ", \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kSeparators);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kSeparators) - first + 1);
}

double parseWord(std::string_view word, const SourceLocation& where, std::string_view name) {
  const auto value = parseNumber(word);
  if (!value) {
    throw SceneError(where, fmt::format("{}: '{}' is no number", name, shown(word)));
  }
  if (!std::isfinite(*value)) {
    throw SceneError(where, fmt::format("{}: '{}' is not finite; give a number", name, shown(word)));
  }
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (std::abs(*value) > kLargest) {
    throw SceneError(where, fmt::format("{}: '{}' is beyond the range of float; at most {}", name,
                                        shown(word), shortNumber(kLargest)));
  }
  return *value;
}

} // namespace

std::vector<double> noriNumbers(std::string_view text, const SourceLocation& where, std::string_view name) {
  std::vector<double> numbers;
  while (true) {
    const auto first = text.find_first_not_of(kSeparators);
    if (first == std::string_view::npos) {
      return numbers;
    }
    text.remove_prefix(first);
    const auto end = std::min(text.find_first_of(kSeparators), text.size());
    numbers.push_back(parseWord(text.substr(0, end), where, name));
    text.remove_prefix(end);
  }
}

double noriNumber(std::string_view text, const SourceLocation& where, std::string_view name) {
  const std::vector<double> numbers = noriNumbers(text, where, name);
  if (numbers.size() != 1) {
    throw SceneError(where, fmt::format("{}: '{}' is {} numbers; give one, with a point for its decimals",
                                        name, shown(text), numbers.size()));
  }
  return numbers.front();
}

int noriInteger(std::string_view text, const SourceLocation& where, std::string_view name) {
  const auto value = parseInteger(trimmed(text));
  if (!value) {
    throw SceneError(where, fmt::format("{}: '{}' is no integer of 32 bits", name, shown(text)));
  }
  return *value;
}

Vec3d noriTriple(std::string_view text, const SourceLocation& where, std::string_view name,
                 std::string_view meaning) {
  const std::vector<double> numbers = noriNumbers(text, where, name);
  if (numbers.size() != 3) {
    throw SceneError(where, fmt::format("{}: '{}' is {} number{}; give three, {}", name, shown(text),
                                        numbers.size(), numbers.size() == 1 ? "" : "s", meaning));
  }
  return {numbers[0], numbers[1], numbers[2]};
}

} // namespace vkpt
