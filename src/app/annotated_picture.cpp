#include "app/annotated_picture.h"

#include "study/html.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt {
namespace {

constexpr double kWidth = 1000.0; // of the drawing, whatever the picture has
constexpr double kBadge = 15.0;   // radius of the circle about a number
constexpr double kGap = 14.0;     // between an arrow's head and its spot

constexpr const char* kSvgStyle =
    "text { font: bold 21px sans-serif; fill: #fff; stroke: #000; stroke-width: 5; paint-order: stroke; } "
    "circle { fill: #fff; stroke: #000; stroke-width: 2; } .number { fill: #000; stroke: none; text-anchor: "
    "middle; } line { stroke-linecap: round; } .under { stroke: #000; stroke-width: 7; } .over { stroke: "
    "#fff; "
    "stroke-width: 3; marker-end: url(#head); }";

std::string arrow(double x0, double y0, double x1, double y1) {
  const double length = std::hypot(x1 - x0, y1 - y0);
  const double dx = (x1 - x0) / length, dy = (y1 - y0) / length;
  const std::string ends = fmt::format("x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}'", x0 + kBadge * dx,
                                       y0 + kBadge * dy, x1 - kGap * dx, y1 - kGap * dy);
  return fmt::format("<line class='under' {}/><line class='over' {}/>\n", ends, ends);
}

} // namespace

std::string annotatedSvg(const fs::path& png, int width, int height,
                         std::span<const Annotation> annotations) {
  const double h = kWidth * height / width;
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {:g} {:g}' width='{:g}' height='{:g}'>\n"
      "<style>{}</style><defs><marker id='head' viewBox='0 0 10 10' refX='7' refY='5' markerWidth='5' "
      "markerHeight='5' orient='auto'><path d='M0 0L10 5L0 10z' fill='#fff' stroke='#000'/></marker></defs>\n"
      "<image href='{}' width='{:g}' height='{:g}'/>\n",
      kWidth, h, kWidth, h, kSvgStyle, html::dataUrl(png, "image/png"), kWidth, h);
  int number = 0;
  for (const Annotation& a : annotations) {
    const double x = a.labelX * kWidth, y = a.labelY * h;
    svg += arrow(x, y, a.spotX * kWidth, a.spotY * h);
    svg +=
        fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='{:g}'/><text class='number' x='{:.1f}' y='{:.1f}'>{}"
                    "</text><text x='{:.1f}' y='{:.1f}'>{}</text>\n",
                    x, y, kBadge, x, y + 7.5, ++number, x + 1.4 * kBadge, y + 7.5, html::escaped(a.label));
  }
  return svg + "</svg>\n";
}

} // namespace vkpt
