#include "app/view/panel.h"

#include "app/expanded_options.h"
#include "app/option_names.h"
#include "app/view/error_curve.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace vkpt {
namespace {

// In heights of a letter.
constexpr float kColumn = 11.0F; // where a second column begins

void line(const std::string& text) { ImGui::TextUnformatted(text.c_str()); }
void wrapped(const std::string& text) {
  ImGui::PushTextWrapPos(kPanelWidth * ImGui::GetFontSize());
  line(text);
  ImGui::PopTextWrapPos();
}

/// A choice among names; the enumerators count from 0.
template<std::size_t N, class Enum>
void choice(const char* label, const std::array<std::string_view, N>& names, Enum& value) {
  if (!ImGui::BeginCombo(label, nameOf(names, value).data()))
    return;
  for (std::size_t i = 0; i < N; ++i) {
    if (ImGui::Selectable(names[i].data(), static_cast<std::size_t>(value) == i))
      value = static_cast<Enum>(i);
  }
  ImGui::EndCombo();
}

std::string stateText(const PanelFacts& facts) {
  if (!facts.rests)
    return facts.coarseness > 1 ? "moving" : "rendering";
  switch (*facts.rests) {
  case StopReason::User:
    return "paused (p goes on)";
  case StopReason::Frames:
    return "done: all frames";
  case StopReason::Time:
    return "done: the time is over";
  case StopReason::Error:
    return "done: the target error is met";
  case StopReason::Fault:
    break;
  }
  return "stopped";
}

void drawState(const PanelFacts& facts, const ViewSettings& settings) {
  const RenderProgress& p = facts.progress;
  line(fmt::format("{}, {}x{}", stateText(facts), facts.filmSize.x, facts.filmSize.y));
  line(fmt::format("{:.1f} frames, {:.1f} s, {:.2f} Msamples/s", p.frames, p.seconds,
                   p.samplesPerSecond * 1e-6));
  if (settings.estimates() && !facts.looks.empty())
    line(fmt::format("error {:.2f} % (95 %: below {:.2f} %)", 100.0 * facts.looks.back().relative,
                     100.0 * p.relativeError.value_or(facts.looks.back().relative)));
  else
    ImGui::TextDisabled("error not known yet");
  drawErrorCurve(facts.looks, settings.job.targetError);
  if (facts.counters.faults() > 0)
    ImGui::TextColored({1.0F, 0.4F, 0.3F, 1.0F}, "%llu FAULTS: the image is wrong there",
                       static_cast<unsigned long long>(facts.counters.faults()));
}

void drawStop(ViewSettings& settings) {
  float percent = static_cast<float>(100.0 * settings.job.targetError.value_or(0.0));
  if (ImGui::InputFloat("target error %", &percent, 0.0F, 0.0F, "%.3g",
                        ImGuiInputTextFlags_EnterReturnsTrue)) {
    settings.job.targetError =
        percent > 0.0F ? std::optional(0.01 * static_cast<double>(percent)) : std::nullopt;
  }
}

void drawRoulette(EstimatorSettings& e) {
  choice("roulette", kRouletteNames, e.roulette);
  if (e.roulette != RouletteMode::Constant)
    return;
  constexpr float kStep = 0.1F;
  constexpr float kMost = 0.95F; // 1 is a limit on bounces
  float termination = static_cast<float>(e.termination);
  if (ImGui::InputFloat("ends with", &termination, kStep, kStep, "%.2f",
                        ImGuiInputTextFlags_EnterReturnsTrue))
    e.termination = static_cast<double>(std::clamp(termination, 0.01F, kMost));
}

void drawKinds(EstimatorSettings& e) {
  line("kinds of light path");
  for (std::uint32_t i = 0; i < kPathKindCount; ++i) {
    if (i % 2 == 1)
      ImGui::SameLine(kColumn * ImGui::GetFontSize());
    bool on = ((e.pathKinds >> i) & 1U) != 0U;
    if (ImGui::Checkbox(kKindNames[i].data(), &on) && (e.pathKinds ^ (1U << i)) != 0U) // one stays
      e.pathKinds ^= 1U << i;
  }
}

/// Splitting and sharing exclude each other: what is chosen last stays.
void drawSplittingAndSharing(EstimatorSettings& e) {
  int split = static_cast<int>(e.splitDepth);
  if (ImGui::InputInt("splitting", &split)) {
    e.splitDepth = static_cast<std::uint32_t>(std::clamp(split, 0, static_cast<int>(shared::kMaxSplitDepth)));
    if (e.splitDepth > 0)
      e.pathReuse = 1;
  }
  enum class Sharing : std::uint8_t { None, Four, Sixteen, Block };
  constexpr std::array<std::string_view, 4> kSharingNames{"1", "4", "16", "64"};
  const auto before = static_cast<Sharing>(std::countr_zero(e.reuseEdge()));
  Sharing sharing = before;
  choice("pixels share paths", kSharingNames, sharing);
  if (sharing != before) {
    e.pathReuse = 1U << (2U * static_cast<std::uint32_t>(sharing));
    if (e.pathReuse > 1)
      e.splitDepth = 0;
  }
}

void drawEstimator(ViewSettings& settings) {
  EstimatorSettings& e = settings.estimator;
  choice("samples", kSamplerNames, e.sampler);
  choice("lights found by", kLightNames, e.light);
  choice("lights chosen by", kLightSelectionNames, e.lightSelection);
  bool limited = e.maxBounces != kUnlimitedBounces;
  if (ImGui::Checkbox("limit bounces", &limited)) {
    constexpr std::uint32_t kFirstLimit = 4;
    e.maxBounces = limited ? kFirstLimit : kUnlimitedBounces;
  }
  if (e.maxBounces != kUnlimitedBounces) {
    int bounces = static_cast<int>(std::min(e.maxBounces, 1000U));
    ImGui::SameLine();
    if (ImGui::InputInt("##bounces", &bounces))
      e.maxBounces = static_cast<std::uint32_t>(std::clamp(bounces, 0, 1000));
  }
  drawRoulette(e);
  drawSplittingAndSharing(e);
  bool fromLights = e.lightTracing != LightTracing::Off;
  if (ImGui::Checkbox("paths from lights", &fromLights))
    e.lightTracing = fromLights ? LightTracing::Auto : LightTracing::Off;
  bool guided = e.guiding != Guiding::Off;
  if (ImGui::Checkbox("guided directions", &guided))
    e.guiding = guided ? Guiding::Auto : Guiding::Off;
  int paths = static_cast<int>(e.specularSamples);
  if (ImGui::InputInt("specular samples", &paths))
    e.specularSamples =
        static_cast<std::uint32_t>(std::clamp(paths, 1, static_cast<int>(shared::kMaxSpecularSamples)));
  drawKinds(e);
}

void drawDisplay(ViewSettings& settings) {
  constexpr float kMostStops = 10.0F;
  float stops = static_cast<float>(settings.display.exposureStops);
  if (ImGui::SliderFloat("exposure", &stops, -kMostStops, kMostStops, "%.2f stops"))
    settings.display.exposureStops = static_cast<double>(stops);
  choice("tonemap", kTonemapNames, settings.display.tonemap);
  bool errors = settings.shows == Shows::StandardError;
  if (ImGui::Checkbox("show the standard error (e)", &errors))
    settings.shows = errors ? Shows::StandardError : Shows::Mean;
}

std::string rgb(const Vec3d& v) { return fmt::format("{:.4g} {:.4g} {:.4g}", v.x, v.y, v.z); }

void drawPixel(const PixelReport& pixel) {
  ImGui::Separator();
  line(fmt::format("pixel {}, {}: {} samples", pixel.pixel.x, pixel.pixel.y, pixel.samples));
  line("mean   " + rgb(pixel.mean));
  line(pixel.samples < 2 ? "+-     not known yet" : "+-     " + rgb(pixel.standardError));
  if (pixel.kindSamples == 0)
    return;
  const auto sum = [](const Vec3d& v) { return v.x + v.y + v.z; };
  double whole = 0.0;
  for (const Vec3d& kind : pixel.kinds)
    whole += std::abs(sum(kind));
  line(fmt::format("of its first {} samples:", pixel.kindSamples));
  for (std::size_t k = 0; k < pixel.kinds.size(); ++k) {
    if (pixel.kinds[k] != Vec3d(0.0))
      line(fmt::format("{:>5.1f} % {:16} {}", 100.0 * sum(pixel.kinds[k]) / whole, kKindNames[k],
                       rgb(pixel.kinds[k])));
  }
}

void drawShaders(ViewSettings& settings) {
  int shader = static_cast<int>(settings.shader);
  for (int i = 0; i < kShaderCount; ++i) {
    if (i % 2 == 1)
      ImGui::SameLine(kColumn * ImGui::GetFontSize());
    ImGui::RadioButton(fmt::format("{} ({})", shaderName(static_cast<Shader>(i)), i).c_str(), &shader, i);
  }
  settings.shader = static_cast<Shader>(shader);
}

void drawRun(const PanelFacts& facts) {
  wrapped(fmt::format("effects: {}", fmt::join(facts.effects, ", ")));
  if (!facts.bias.empty())
    wrapped(fmt::format("biased by: {}", fmt::join(facts.bias, ", ")));
  wrapped(facts.device);
}

PanelRequests drawButtons() {
  PanelRequests requests;
  requests.save = ImGui::Button("save (b)");
  ImGui::SameLine();
  requests.printCamera = ImGui::Button("camera (c)");
  ImGui::SameLine();
  requests.frameScene = ImGui::Button("frame (f)");
  ImGui::SameLine();
  requests.homeCamera = ImGui::Button("home");
  return requests;
}

void drawHelp() {
  if (!ImGui::CollapsingHeader("mouse and keys"))
    return;
  line("left drag     orbit\nmiddle drag   pan (or Shift and left)\nwheel         dolly\n"
       "right drag    look; with W A S D Q E flight, Shift: faster\nclick         centre of the orbit\n"
       "middle click  what a pixel is made of\n0 1 2 3       base colour, direct light, normals, paths\n"
       "r, t          path tracing on and off\n+ - *         exposure, tonemap\np             pause\n"
       "f, Home       frame the scene, first camera\nb, Ctrl+S     save PNG and EXR\nc             print the "
       "camera\n"
       "e             standard error\nh             this panel\nEsc           quit");
}

void drawMessage(const std::string& message) {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const float margin = ImGui::GetTextLineHeight();
  ImGui::SetNextWindowPos({viewport->Pos.x + margin, viewport->Pos.y + viewport->Size.y - margin},
                          ImGuiCond_Always, {0.0F, 1.0F});
  ImGui::SetNextWindowBgAlpha(0.7F);
  if (ImGui::Begin("##message", nullptr,
                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                       ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing))
    line(message);
  ImGui::End();
}

} // namespace

PanelRequests drawPanel(const PanelFacts& facts, ViewSettings& settings) {
  if (!facts.message.empty())
    drawMessage(facts.message);
  PanelRequests requests;
  if (!settings.panel)
    return requests;
  const float unit = ImGui::GetFontSize();
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  ImGui::SetNextWindowPos({viewport->Pos.x + unit, viewport->Pos.y + unit}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {viewport->Size.x, viewport->Size.y - 2.0F * unit});
  ImGui::SetNextWindowBgAlpha(0.8F);
  if (ImGui::Begin(fmt::format("{}###panel", facts.scene).c_str(), &settings.panel,
                   ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::PushItemWidth(9.0F * unit);
    drawState(facts, settings);
    drawStop(settings);
    drawShaders(settings);
    if (settings.estimates() && ImGui::CollapsingHeader("light transport"))
      drawEstimator(settings);
    if (ImGui::CollapsingHeader("display"))
      drawDisplay(settings);
    if (ImGui::CollapsingHeader("what is rendered"))
      drawRun(facts);
    if (facts.pixel)
      drawPixel(*facts.pixel);
    requests = drawButtons();
    drawHelp();
    ImGui::PopItemWidth();
  }
  ImGui::End();
  return requests;
}

} // namespace vkpt
