#include "view/screen.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace vkpt::test {
namespace {

constexpr auto kScreenPoll = std::chrono::milliseconds(20);
constexpr int kScreenPolls = 1000; // 20 s

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = (value << 8U) | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

} // namespace

Screenshot Screenshot::cut(int newWidth, int newHeight) const {
  Screenshot part{newWidth, newHeight, {}};
  for (int y = 0; y < newHeight; ++y) {
    for (int x = 0; x < newWidth; ++x)
      part.pixels.push_back(at(x, y));
  }
  return part;
}

Screen::Screen() {
  const std::string number = m_folder / "number";
  const std::string folder = m_folder.path();
  m_process = ::fork();
  if (m_process == 0) {
    // The server writes the number that it found free.
    const std::string command = "exec Xvfb -displayfd 3 -screen 0 800x700x24 -fbdir '" + folder +
                                "' -nolisten tcp -noreset 3>'" + number + "' 2>'" + folder + "/log' >&2";
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  for (int i = 0; i < kScreenPolls && m_display.empty(); ++i) {
    std::this_thread::sleep_for(kScreenPoll);
    const std::string text = fs::exists(number) ? m_folder.read("number") : "";
    if (text.ends_with('\n'))
      m_display = fmt::format(":{}", text.substr(0, text.size() - 1));
  }
  if (m_display.empty())
    throw std::runtime_error("Xvfb did not start: cmake/setup.sh test");
}

Screen::~Screen() {
  ::kill(m_process, SIGTERM);
  ::waitpid(m_process, nullptr, 0);
}

/// The server's memory is a file in the format of xwd: a header, colours that are not used, rows of B G R x.
Screenshot Screen::shoot() const {
  const std::string bytes = m_folder.read("Xvfb_screen0");
  constexpr std::size_t kColourBytes = 12;
  const auto header = [&](std::size_t field) { return std::size_t{bigEndian(bytes, 4 * field)}; };
  Screenshot shot{static_cast<int>(header(4)), static_cast<int>(header(5)), {}};
  const std::size_t rows = header(0) + header(19) * kColourBytes;
  for (std::size_t y = 0; y < header(5); ++y) {
    for (std::size_t x = 0; x < header(4); ++x) {
      const std::size_t at = rows + y * header(12) + 4 * x;
      const auto byte = [&](std::size_t i) { return int{static_cast<unsigned char>(bytes.at(at + i))}; };
      shot.pixels.push_back({byte(2), byte(1), byte(0)});
    }
  }
  return shot;
}

void Screen::user(const std::string& words) const {
  const std::string command = "DISPLAY=" + m_display + " xdotool " + words;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

} // namespace vkpt::test
