// What the user does to the preview.

#include "app/view/session.h"

#include "app/interrupt.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace vkpt {

void Session::moved() {
  m_sinceMove.restart();
  m_moved = true;
}

void Session::hear() {
  const Input input = m_window.takeInput();
  if (input.any || input.flying) {
    m_sinceInput.restart();
    m_stale = true;
  }
  m_quit = m_quit || input.quit || InterruptGuard::requested();
  hearKeys(input);
  hearMouse(input);
  if (const Vec2i size = m_window.size(); size.x > 0 && size.y > 0 && size != m_windowSize) {
    m_log.write("resized", {{"size", numbers(size)}});
    m_windowSize = size;
    moved();
  }
}

void Session::hearMouse(const Input& input) {
  const double height = std::max(1, m_windowSize.y);
  const double aspect = m_windowSize.x / height;
  const double sinceFlight = m_sinceFlight.restart();
  if (input.orbit != Vec2d(0.0))
    m_rig.orbit(input.orbit / height);
  if (input.pan != Vec2d(0.0))
    m_rig.pan(input.pan / height, aspect);
  if (input.dolly != 0.0)
    m_rig.dolly(input.dolly);
  if (input.look != Vec2d(0.0))
    m_rig.look(input.look / height);
  const bool flies = input.flying && input.flight != Vec3d(0.0);
  if (flies) {
    constexpr double kPerSecond = 0.25; // of the scene's diagonal
    constexpr double kLongestStep = 0.1;
    const double way = glm::length(m_box.extent()) * kPerSecond * std::min(sinceFlight, kLongestStep);
    m_rig.fly(input.flight * way * (input.fast ? 4.0 : 1.0));
  }
  if (flies || input.orbit != Vec2d(0.0) || input.pan != Vec2d(0.0) || input.dolly != 0.0 ||
      input.look != Vec2d(0.0))
    moved();
  if (input.click) {
    if (const auto point = pointAt(m_stage, pixelAt(*input.click))) {
      m_rig.setPivot(*point);
      say(fmt::format("the camera turns about {:.4g}, {:.4g}, {:.4g}", point->x, point->y, point->z));
      m_log.write("pivot", {{"point", numbers(*point)}});
    }
  }
  if (input.middleClick) {
    m_facts.pixel = reportPixel(m_stage, m_begun, pixelAt(*input.middleClick));
    m_settings.panel = true;
    const PixelReport& p = *m_facts.pixel;
    nlohmann::json kinds = nlohmann::json::array();
    for (const Vec3d& kind : p.kinds)
      kinds.push_back(numbers(kind));
    m_log.write("pixel", {{"pixel", numbers(p.pixel)},
                          {"samples", p.samples},
                          {"mean", numbers(p.mean)},
                          {"standardError", numbers(p.standardError)},
                          {"kinds", kinds},
                          {"kindSamples", p.kindSamples}});
  }
}

Vec2i Session::pixelAt(Vec2d position) const {
  const Vec2d share = position / Vec2d(glm::max(m_windowSize, Vec2i(1)));
  return glm::clamp(Vec2i(glm::floor(share * Vec2d(m_facts.filmSize))), Vec2i(0),
                    m_facts.filmSize - Vec2i(1));
}

void Session::hearKeys(const Input& input) {
  PanelRequests requests;
  requests.save = input.save;
  requests.homeCamera = input.home;
  constexpr double kExposureStep = 0.25; // stops
  for (const char32_t key : input.typed) {
    if (key >= U'0' && key < U'0' + kShaderCount)
      m_settings.shader = static_cast<Shader>(key - U'0');
    switch (key) {
    case U'r':
    case U't':
      m_settings.shader =
          m_settings.shader == Shader::PathTracing ? Shader::DirectLight : Shader::PathTracing;
      break;
    case U'+':
      m_settings.display.exposureStops += kExposureStep;
      break;
    case U'-':
      m_settings.display.exposureStops -= kExposureStep;
      break;
    case U'*':
      m_settings.display.tonemap =
          static_cast<Tonemap>((static_cast<int>(m_settings.display.tonemap) + 1) % 3);
      break;
    case U'p':
      m_settings.paused = !m_settings.paused;
      break;
    case U'h':
      m_settings.panel = !m_settings.panel;
      break;
    case U'e':
      m_settings.shows = m_settings.shows == Shows::Mean ? Shows::StandardError : Shows::Mean;
      break;
    case U'b':
      requests.save = true;
      break;
    case U'c':
      requests.printCamera = true;
      break;
    case U'f':
      requests.frameScene = true;
      break;
    default:
      break;
    }
    m_log.write("key", {{"character", static_cast<std::uint32_t>(key)}});
  }
  hearPanel(requests);
}

void Session::hearPanel(const PanelRequests& requests) {
  const double aspect = static_cast<double>(m_windowSize.x) / std::max(1, m_windowSize.y);
  if (requests.save)
    save();
  if (requests.printCamera) {
    fmt::print("{}\n", cameraOptions(m_rig.camera(), aspect));
    std::fflush(stdout);
    say("the camera's options are printed where vkpt was started");
  }
  if (requests.frameScene)
    m_rig.frame(m_box, aspect);
  if (requests.homeCamera)
    m_rig = CameraRig(m_home, m_home.target);
  if (requests.frameScene || requests.homeCamera)
    moved();
}

void Session::say(const std::string& message) {
  m_facts.message = message;
  m_sinceMessage.restart();
  m_stale = true;
}

} // namespace vkpt
