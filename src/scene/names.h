#pragma once
// Names as users type them.

#include <span>
#include <string>
#include <string_view>

namespace vkpt {

/// ASCII letters only: the same in every locale.
std::string lowerCase(std::string_view text);

/// The candidate with the fewest edits, by case-insensitive Levenshtein distance; empty when all are far off.
std::string_view nearestName(std::string_view typed, std::span<const std::string_view> candidates);

/// ", did you mean 'x'?", or nothing.
std::string didYouMean(std::string_view typed, std::span<const std::string_view> candidates);

/// A piece of a file as a message shows it: without control characters, and not all of a long one.
std::string shown(std::string_view piece);

/// A number as a message shows it: six digits, no trailing zeros.
std::string shortNumber(double value);

} // namespace vkpt
