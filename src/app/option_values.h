#pragma once
// The values of options. Each function throws UsageError: one line with the option, what was typed, and what
// would be right.

#include "core/error.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vkpt {

[[noreturn]] void refuseValue(std::string_view option, std::string_view typed, std::string_view right);

/// A whole number in [least, most].
std::uint64_t parseWhole(std::string_view option, std::string_view text, std::uint64_t least,
                         std::uint64_t most);
/// A finite number; `right` says which, for the message.
double parseFinite(std::string_view option, std::string_view text, std::string_view right);
/// A finite number above 0.
double parsePositive(std::string_view option, std::string_view text, std::string_view right);
/// Comma-separated finite numbers, exactly `count` of them.
std::vector<double> parseList(std::string_view option, std::string_view text, std::size_t count,
                              std::string_view right);
/// "512x512"
std::pair<int, int> parseSize(std::string_view option, std::string_view text);
/// Where `text` is among `names`.
std::size_t parseName(std::string_view option, std::string_view text,
                      std::span<const std::string_view> names);

} // namespace vkpt
