#include "view/preview.h"

#include "decode/stb.h"
#include "film/codecs.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace vkpt::test {
namespace {

constexpr auto kPoll = std::chrono::milliseconds(20);
constexpr int kPolls = 3000; // a minute
constexpr auto kShotPoll = std::chrono::milliseconds(100);

CommandSettings settingsFor(const Screen& screen, const WorkFolder& folder, bool validation) {
  CommandSettings settings;
  settings.folder = folder.path();
  settings.environment["DISPLAY"] = screen.display();
  settings.validation = validation;
  return settings;
}

std::vector<std::string> viewArguments(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "view");
  arguments.emplace_back("--log-events");
  return arguments;
}

/// The complete lines of JSON in `text` from `at` on, which is moved behind each.
std::optional<nlohmann::json> nextEvent(const std::string& text, std::size_t& at) {
  for (;;) {
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos)
      return std::nullopt;
    const auto line = nlohmann::json::parse(text.substr(at, end - at), nullptr, false);
    at = end + 1;
    if (line.is_object())
      return line;
  }
}

} // namespace

Preview::Preview(const Screen& screen, const WorkFolder& folder, std::vector<std::string> arguments,
                 bool validation)
    : m_screen(screen),
      m_command(viewArguments(std::move(arguments)), settingsFor(screen, folder, validation)) {}

nlohmann::json Preview::await(const std::string& event) {
  for (int i = 0; i < kPolls; ++i) {
    const std::string text = m_command.output();
    while (const auto line = nextEvent(text, m_read)) {
      if ((*line)["event"] == event)
        return *line;
    }
    if (m_command.hasEnded())
      break;
    std::this_thread::sleep_for(kPoll);
  }
  ADD_FAILURE() << "no event '" << event << "' behind\n" << m_command.output() << m_command.errorOutput();
  return nlohmann::json::object();
}

std::vector<nlohmann::json> Preview::events(const std::string& event) const {
  std::vector<nlohmann::json> found;
  const std::string text = m_command.output();
  std::size_t at = 0;
  while (const auto line = nextEvent(text, at)) {
    if ((*line)["event"] == event)
      found.push_back(*line);
  }
  return found;
}

std::optional<std::size_t> Preview::differences(const Screenshot& expected) const {
  std::optional<std::size_t> best;
  m_screen.user("mousemove 799 699"); // the server draws the cursor into the picture
  constexpr int kTries = 100;         // ten seconds: a message over the picture stays for four
  for (int i = 0; i < kTries && !best; ++i) {
    const Screenshot shot = m_screen.shoot().cut(expected.width, expected.height);
    std::size_t count = 0;
    bool close = true;
    for (std::size_t pixel = 0; pixel < shot.pixels.size(); ++pixel) {
      for (std::size_t c = 0; c < 3; ++c) {
        const int difference = std::abs(shot.pixels[pixel][c] - expected.pixels[pixel][c]);
        close = close && difference <= 1;
        count += difference != 0 ? 1 : 0;
      }
    }
    if (close)
      best = count;
    else
      std::this_thread::sleep_for(kShotPoll);
  }
  return best;
}

CommandResult Preview::quit() {
  press("Escape");
  return m_command.wait();
}

Screenshot readPng(const fs::path& file) {
  const decode::Samples png = decode::stbDecode(film::readWholeFile(file));
  Screenshot shot{png.width, png.height, {}};
  const auto pixels = static_cast<std::size_t>(png.width) * static_cast<std::size_t>(png.height);
  for (std::size_t i = 0; i < 3 * pixels; i += 3)
    shot.pixels.push_back({png.rgb[i] / 257, png.rgb[i + 1] / 257, png.rgb[i + 2] / 257});
  return shot;
}

} // namespace vkpt::test
