#pragma once
// The texts of attributes as numbers. They are split by commas and blanks, and do not depend on the locale.

#include "core/error.h"
#include "core/math.h"

#include <string_view>
#include <vector>

namespace vkpt {

/// All of these throw SceneError at `where` for a word that is no number, is not finite or is beyond the
/// range of float; `name` is what the number is of, for the message.
std::vector<double> noriNumbers(std::string_view text, const SourceLocation& where, std::string_view name);
/// Exactly one.
double noriNumber(std::string_view text, const SourceLocation& where, std::string_view name);
int noriInteger(std::string_view text, const SourceLocation& where, std::string_view name);
/// Exactly three; `meaning` says which: "r g b".
Vec3d noriTriple(std::string_view text, const SourceLocation& where, std::string_view name,
                 std::string_view meaning);

} // namespace vkpt
