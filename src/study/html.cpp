#include "study/html.h"

#include "film/file_io.h"

#include <fmt/format.h>

namespace vkpt::html {
namespace {

std::string base64(film::ByteView bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = (word << 8U) | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[(word >> (18U - 6U * k)) & 63U] : '=';
  }
  return text;
}

} // namespace

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
    case '&':
      html += "&amp;";
      break;
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    case '"':
      html += "&quot;";
      break;
    default:
      html += c;
    }
  }
  return html;
}

std::string dataUrl(const fs::path& file, std::string_view type) {
  return fmt::format("data:{};base64,{}", type, base64(film::readWholeFile(file)));
}

std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<table><tr>";
  for (const auto& h : head)
    html += "<th>" + h + "</th>";
  html += "</tr>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (const auto& value : row)
      html += "<td>" + value + "</td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string figure(std::string_view kind, const fs::path& png, std::string_view caption) {
  return fmt::format("<figure class={}><img alt=\"{}\" src='{}'><figcaption>{}</figcaption></figure>\n", kind,
                     escaped(caption), dataUrl(png, "image/png"), escaped(caption));
}

std::string page(std::string_view title, std::string_view style, std::string_view body,
                 std::string_view script) {
  return fmt::format("<!DOCTYPE html><html lang=en><head><meta charset=utf-8><title>{}</title>"
                     "<link rel=icon href='data:,'><style>{}</style></head><body>\n{}<script>{}</script>"
                     "</body></html>\n",
                     escaped(title), style, body, script);
}

} // namespace vkpt::html
