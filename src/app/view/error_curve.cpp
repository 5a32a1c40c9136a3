#include "app/view/error_curve.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

constexpr float kHeight = 6.0F;  // of the plot, in heights of a letter
constexpr double kPadding = 0.1; // decades beyond the data

struct Range {
  double least = 0.0;
  double most = 1.0;
  void extend(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
  /// Where x lies, from 0 to 1.
  [[nodiscard]] float at(double x) const { return static_cast<float>((x - least) / (most - least)); }
};

std::string timeText(double seconds) {
  return seconds < 100.0 ? fmt::format("{:.2g} s", seconds) : fmt::format("{:.0f} s", seconds);
}

} // namespace

void drawErrorCurve(const std::vector<ErrorLook>& looks, std::optional<double> target) {
  std::vector<std::pair<double, double>> points; // decades
  for (const ErrorLook& look : looks) {
    if (look.seconds > 0.0 && look.relative > 0.0 && std::isfinite(look.relative))
      points.emplace_back(std::log10(look.seconds), std::log10(look.relative));
  }
  if (points.size() < 2) {
    return;
  }
  Range x{points.front().first, points.back().first + 1e-3};
  Range y{points.front().second, points.front().second};
  for (const auto& point : points)
    y.extend(point.second);
  if (target)
    y.extend(std::log10(*target));
  y = {y.least - kPadding, y.most + kPadding};

  const float width = kPanelWidth * ImGui::GetFontSize();
  const float height = kHeight * ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width, height});
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto place = [&](double px, double py) {
    return ImVec2(corner.x + x.at(px) * width, corner.y + (1.0F - y.at(py)) * height);
  };
  list->AddRectFilled(corner, {corner.x + width, corner.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  const ImU32 grid = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.4F);
  for (double decade = std::ceil(y.least); decade <= y.most; decade += 1.0)
    list->AddLine(place(x.least, decade), place(x.most, decade), grid);
  for (double decade = std::ceil(x.least); decade <= x.most; decade += 1.0)
    list->AddLine(place(decade, y.least), place(decade, y.most), grid);
  if (target)
    list->AddLine(place(x.least, std::log10(*target)), place(x.most, std::log10(*target)),
                  IM_COL32(90, 200, 120, 255));
  const ImU32 line = ImGui::GetColorU32(ImGuiCol_PlotLines);
  for (std::size_t i = 1; i < points.size(); ++i)
    list->AddLine(place(points[i - 1].first, points[i - 1].second), place(points[i].first, points[i].second),
                  line, 2.0F);
  const ImU32 text = ImGui::GetColorU32(ImGuiCol_Text);
  const float margin = 3.0F;
  const std::string high = fmt::format("{:.2g} %", 100.0 * std::pow(10.0, points.front().second));
  const std::string low = fmt::format("{:.2g} %, {}", 100.0 * std::pow(10.0, points.back().second),
                                      timeText(std::pow(10.0, points.back().first)));
  list->AddText({corner.x + margin, corner.y + height - ImGui::GetTextLineHeight() - margin}, text,
                high.c_str());
  const ImVec2 size = ImGui::CalcTextSize(low.c_str());
  list->AddText({corner.x + width - size.x - margin, corner.y + margin}, text, low.c_str());
}

} // namespace vkpt
