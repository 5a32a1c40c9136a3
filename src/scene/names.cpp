#include "scene/names.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace vkpt {

namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

} // namespace

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    }
  }
  return lower;
}

std::string_view nearestName(std::string_view typed, std::span<const std::string_view> candidates) {
  // A longer word is no typing error, and the distance takes quadratic time.
  constexpr std::size_t kLongest = 200;
  if (typed.empty() || typed.size() > kLongest) {
    return {};
  }
  const std::string lower = lowerCase(typed);
  std::size_t fewest = std::max<std::size_t>(1, typed.size() / 3) + 1;
  std::string_view nearest;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = editDistance(lower, lowerCase(candidate));
    if (distance < fewest) {
      fewest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string didYouMean(std::string_view typed, std::span<const std::string_view> candidates) {
  const std::string_view nearest = nearestName(typed, candidates);
  return nearest.empty() ? std::string() : fmt::format(", did you mean '{}'?", shown(nearest));
}

std::string shown(std::string_view piece) {
  constexpr std::size_t kLongest = 60;
  std::string text(piece.substr(0, kLongest));
  std::ranges::replace_if(
      text, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, '?');
  return piece.size() > kLongest ? text + "..." : text;
}

std::string shortNumber(double value) { return fmt::format("{:.6g}", value); }

} // namespace vkpt
