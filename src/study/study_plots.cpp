// The plots, drawn by gnuplot.

#include "core/error.h"
#include "film/file_io.h"
#include "film/power_law.h"
#include "study/study_report.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace vkpt {
namespace {

constexpr const char* kScript = "plots.gnuplot";
/// M. Okabe, K. Ito 2008: told apart with any colour vision.
constexpr std::array<const char*, 8> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                              "#E69F00", "#56B4E9", "#000000", "#A6761D"};

/// Runs gnuplot in `folder`; -1 where it can't be started, else its exit status.
int runGnuplot(const fs::path& folder, const char* argument) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = "gnuplot", word = argument;
  std::array<char*, 3> arguments{name.data(), word.data(), nullptr};
  pid_t process = 0;
  const int failure = posix_spawnp(&process, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failure != 0)
    return -1;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string quoted(const std::string& text) {
  std::string q = "'";
  for (const char c : text)
    q += c == '\'' ? std::string("''") : std::string(1, c);
  return q + "'";
}

double workOf(const CurvePoint& p, bool byTime) { return byTime ? p.seconds : p.frames; }

std::string slopeText(const SettingSummary& s, bool byTime) {
  const auto& slope = byTime ? s.slopeOverTime : s.slopeOverFrames;
  if (!slope)
    return s.name;
  return fmt::format("{}: slope of log relMSE {:.2f}{}", s.name, slope->value,
                     slope->standardError ? fmt::format(" ± {:.2f}", *slope->standardError) : "");
}

std::string dataBlocks(const std::vector<SettingSummary>& summaries) {
  std::string text;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    text += fmt::format("$s{} << EOD\n", i);
    for (const CurvePoint& p : summaries[i].curve)
      text += fmt::format("{} {} {} {} {}\n", p.seconds, p.frames, p.error.median * 100.0,
                          p.error.least * 100.0, p.error.most * 100.0);
    text += "EOD\n";
  }
  return text;
}

std::string plotCommand(const std::vector<SettingSummary>& summaries, bool byTime) {
  std::string text;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const SettingSummary& s = summaries[i];
    if (s.curve.empty())
      continue;
    const char* colour = kColours.at(i % kColours.size());
    text += text.empty() ? "plot " : ", \\\n  ";
    text += fmt::format("$s{} using {}:3:4:5 with yerrorbars pt 7 ps 0.6 lw 1.5 lc rgb '{}' title {}", i,
                        byTime ? 1 : 2, colour, quoted(slopeText(s, byTime)));
    std::vector<ErrorAtWork> points;
    for (const CurvePoint& p : settledPart(s.curve))
      points.push_back({workOf(p, byTime), p.error.median * 100.0});
    if (const auto law = fitPowerLaw(points))
      text += fmt::format(", \\\n  [{}:{}] {}*x**({}) with lines lw 1.2 lc rgb '{}' notitle",
                          points.front().work, points.back().work, law->factor, law->exponent, colour);
  }
  return text;
}

std::string figure(const std::vector<SettingSummary>& summaries, bool byTime) {
  const std::string name = byTime ? "error-time" : "error-frames";
  const std::string plot = plotCommand(summaries, byTime);
  if (plot.empty())
    return {};
  return fmt::format("set xlabel '{}'\n"
                     "set terminal svg size 860,560 noenhanced font 'sans-serif,13' background 'white'\n"
                     "set output '{}.svg'\n{}\n"
                     "set terminal pngcairo size 1290,840 noenhanced font 'sans-serif,13'\n"
                     "set output '{}.png'\nreplot\nunset output\n",
                     byTime ? "rendering time / s" : "samples per pixel", name, plot, name);
}

} // namespace

void checkGnuplot() {
  if (runGnuplot(".", "--version") != 0)
    throw UsageError(
        "study: gnuplot, which draws the plots, cannot be started; Debian's package is gnuplot-nox "
        "(cmake/setup.sh installs it)");
}

void drawPlots(const fs::path& folder, const std::vector<SettingSummary>& summaries) {
  const std::string script = "set encoding utf8\nset logscale xy\nset grid\nset format y '%g'\n"
                             "set format x '%g'\nset ylabel 'relative error / %'\n"
                             "set key below left vertical maxcols 1 height 2\n" +
                             dataBlocks(summaries) + figure(summaries, true) + figure(summaries, false);
  film::writeTextFile(folder / kScript, script);
  if (runGnuplot(folder, kScript) != 0)
    throw Error(ExitCode::Usage, fmt::format("{}: gnuplot could not draw it; its message stands above",
                                             (folder / kScript).string()));
}

} // namespace vkpt
