#pragma once
// Runs the real binary, as a user would, and tells what it said.

#include "core/error.h"

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace vkpt::test {

/// A folder of its own, removed with all it holds.
class WorkFolder {
public:
  WorkFolder();
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  [[nodiscard]] fs::path operator/(const std::string& name) const { return m_path / name; }
  [[nodiscard]] const fs::path& path() const { return m_path; }
  void write(const std::string& name, std::string_view text) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  [[nodiscard]] nlohmann::json json(const std::string& name) const;
  /// The names in it, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

private:
  fs::path m_path;
};

struct CommandResult {
  int exitCode = -1;      ///< -1: ended by a signal
  int signal = 0;         ///< which ended it, 0: none
  std::string out;        ///< stdout
  std::string err;        ///< stderr
  double seconds = 0.0;   ///< from start to end
  double peakBytes = 0.0; ///< of resident memory

  /// The lines of stderr that start with "vkpt: error: ", without that; warnings likewise.
  [[nodiscard]] std::vector<std::string> errors() const;
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// Lines of stderr that are neither.
  [[nodiscard]] std::vector<std::string> otherLines() const;
};

struct CommandSettings {
  fs::path folder;                                ///< to run in
  std::map<std::string, std::string> environment; ///< besides this process's
  bool validation = true;                         ///< adds --validation
  std::string program{};                          ///< full path; empty: vkpt
  double patience = 120.0;                        ///< seconds after which it is killed, and the test fails
};

/// `vkpt` under way. Killed when it outlives this object.
class RunningCommand {
public:
  RunningCommand(std::vector<std::string> arguments, const CommandSettings& settings);
  ~RunningCommand();
  RunningCommand(const RunningCommand&) = delete;
  RunningCommand& operator=(const RunningCommand&) = delete;

  /// Waits until `text` stands in stderr; false when it has not within `seconds`.
  [[nodiscard]] bool waitForError(std::string_view text, double seconds) const;
  /// What stands in stdout and stderr so far.
  [[nodiscard]] std::string output() const { return m_streams.read("out"); }
  [[nodiscard]] std::string errorOutput() const { return m_streams.read("err"); }
  [[nodiscard]] bool hasEnded() const;
  void signal(int number) const;
  /// Waits for its end; kills it when the patience is at its end.
  CommandResult wait();

private:
  WorkFolder m_streams;
  pid_t m_process = -1;
  double m_started = 0.0;
  double m_patience;
};

CommandResult vkpt(const std::vector<std::string>& arguments, const CommandSettings& settings);

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Into the test's output, for figures that are told and not tested.
void tell(const std::string& what, double figure, const std::string& unit);

/// A call that the command refuses, and what its line holds.
struct WrongCall {
  const char* name;
  std::vector<std::string> arguments;
  ExitCode code;
  std::vector<const char*> says;
};
inline void PrintTo(const WrongCall& call, std::ostream* out) { *out << call.name; }

} // namespace vkpt::test
