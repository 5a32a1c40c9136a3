#pragma once
// Pieces of a page that stands alone: text, tables, and files as data in it.

#include "core/error.h"

#include <string>
#include <string_view>
#include <vector>

namespace vkpt::html {

/// As text, or as an attribute between quotation marks.
std::string escaped(std::string_view text);

/// The file in a URL (RFC 2397, RFC 4648). Throws SceneError.
std::string dataUrl(const fs::path& file, std::string_view type);

/// `head` and `rows` are HTML, the first column stands left.
std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);

/// <figure class=KIND> with the picture in it; `caption` is text.
std::string figure(std::string_view kind, const fs::path& png, std::string_view caption);

/// A whole page; `title` is text, the others are as they stand.
std::string page(std::string_view title, std::string_view style, std::string_view body,
                 std::string_view script);

} // namespace vkpt::html
