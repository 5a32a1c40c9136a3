#include "cli/command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace vkpt::test {
namespace {

constexpr double kPatience = 120.0; // seconds; no command of the tests takes as long
constexpr auto kPollInterval = std::chrono::milliseconds(5);

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string textOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

constexpr std::string_view kError = "vkpt: error: ";
constexpr std::string_view kWarning = "vkpt: warning: ";

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

std::vector<std::string> linesBehind(std::string_view prefix, const std::string& text) {
  std::vector<std::string> lines;
  for (const auto& line : linesOf(text)) {
    if (line.starts_with(prefix))
      lines.push_back(line.substr(prefix.size()));
  }
  return lines;
}

/// In the child: from here on only calls that are safe after a fork.
[[noreturn]] void execute(char* const* arguments, char* const* environment, const char* folder,
                          const char* out, const char* err) {
  const int input = ::open("/dev/null", O_RDONLY);
  const int output = ::open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int errors = ::open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const bool ready = ::dup2(input, STDIN_FILENO) >= 0 && ::dup2(output, STDOUT_FILENO) >= 0 &&
                     ::dup2(errors, STDERR_FILENO) >= 0 && ::chdir(folder) == 0;
  if (ready)
    ::execve(arguments[0], arguments, environment);
  ::_exit(127);
}

std::vector<char*> pointersTo(std::vector<std::string>& strings) {
  std::vector<char*> pointers;
  for (auto& s : strings)
    pointers.push_back(s.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environmentWith(const std::map<std::string, std::string>& changes) {
  std::vector<std::string> entries;
  for (char** entry = ::environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!changes.contains(text.substr(0, text.find('='))))
      entries.push_back(text);
  }
  for (const auto& [name, value] : changes)
    entries.push_back(name + "=" + value);
  return entries;
}

} // namespace

WorkFolder::WorkFolder() {
  std::string name = (fs::temp_directory_path() / "vkpt-cli-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("no temporary folder");
  m_path = name;
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(m_path, ignored);
}

void WorkFolder::write(const std::string& name, std::string_view text) const {
  std::ofstream(m_path / name, std::ios::binary) << text;
}

std::string WorkFolder::read(const std::string& name) const { return textOf(m_path / name); }

nlohmann::json WorkFolder::json(const std::string& name) const {
  return nlohmann::json::parse(read(name), nullptr, false);
}

std::vector<std::string> WorkFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(m_path))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> CommandResult::errors() const { return linesBehind(kError, err); }
std::vector<std::string> CommandResult::warnings() const { return linesBehind(kWarning, err); }

std::vector<std::string> CommandResult::otherLines() const {
  std::vector<std::string> lines = linesOf(err);
  std::erase_if(lines, [](const auto& l) { return l.starts_with(kError) || l.starts_with(kWarning); });
  return lines;
}

RunningCommand::RunningCommand(std::vector<std::string> arguments, const CommandSettings& settings) {
  arguments.insert(arguments.begin(), settings.program.empty() ? VKPT_COMMAND : settings.program);
  if (settings.validation)
    arguments.emplace_back("--validation");
  std::vector<std::string> environment = environmentWith(settings.environment);
  const std::vector<char*> argumentPointers = pointersTo(arguments);
  const std::vector<char*> environmentPointers = pointersTo(environment);
  const std::string out = m_streams / "out";
  const std::string err = m_streams / "err";
  m_started = now();
  m_process = ::fork();
  if (m_process == 0)
    execute(argumentPointers.data(), environmentPointers.data(), settings.folder.c_str(), out.c_str(),
            err.c_str());
  if (m_process < 0)
    throw std::runtime_error("cannot fork");
}

RunningCommand::~RunningCommand() {
  if (m_process > 0) {
    ::kill(m_process, SIGKILL);
    ::waitpid(m_process, nullptr, 0);
  }
}

bool RunningCommand::waitForError(std::string_view text, double seconds) const {
  const double end = now() + seconds;
  while (now() < end) {
    if (m_streams.read("err").find(text) != std::string::npos)
      return true;
    std::this_thread::sleep_for(kPollInterval);
  }
  return false;
}

bool RunningCommand::hasEnded() const {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(m_process), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         info.si_pid != 0;
}

void RunningCommand::signal(int number) const { ::kill(m_process, number); }

CommandResult RunningCommand::wait() {
  int status = 0;
  rusage usage{};
  while (::wait4(m_process, &status, WNOHANG, &usage) == 0) {
    if (now() - m_started > kPatience) {
      ADD_FAILURE() << "vkpt did not end within " << kPatience << " s";
      signal(SIGKILL);
    }
    std::this_thread::sleep_for(kPollInterval);
  }
  m_process = -1;
  CommandResult r;
  r.seconds = now() - m_started;
  r.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  r.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  r.peakBytes = static_cast<double>(usage.ru_maxrss) * 1024.0;
  r.out = m_streams.read("out");
  r.err = m_streams.read("err");
  return r;
}

CommandResult vkpt(const std::vector<std::string>& arguments, const CommandSettings& settings) {
  return RunningCommand(arguments, settings).wait();
}

void tell(const std::string& what, double figure, const std::string& unit) {
  fmt::print("{}: {:.4g} {}\n", what, figure, unit);
  testing::Test::RecordProperty(what, fmt::format("{:.4g} {}", figure, unit));
}

} // namespace vkpt::test
