#pragma once
// Errors that reach the user: one line each, and the exit code that interface promises.

#include <filesystem>
#include <stdexcept>
#include <string>

namespace vkpt {

namespace fs = std::filesystem;

/// Process exit codes; scripts rely on them.
enum class ExitCode : int {
  Done = 0,
  Usage = 1,
  Scene = 2,
  Device = 3,
  Comparison = 4,
  Faults = 5,
  Interrupted = 75,
};

/// A fault of the world (input, device, file system), never of our code: those are asserts.
/// `what()` is one line: file:line where there is one, what is wrong, what would be right.
class Error : public std::runtime_error {
public:
  Error(ExitCode code, const std::string& what) : std::runtime_error(what), m_code(code) {}
  [[nodiscard]] ExitCode code() const { return m_code; }

private:
  ExitCode m_code;
};

class UsageError : public Error {
public:
  explicit UsageError(const std::string& what) : Error(ExitCode::Usage, what) {}
};

class DeviceError : public Error {
public:
  explicit DeviceError(const std::string& what) : Error(ExitCode::Device, what) {}
};

/// Where in an input file something stands, both from 1; `line` 0: the file as a whole; `column` 0: not
/// known.
struct SourceLocation {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  /// file:line:column, as far as they are known.
  [[nodiscard]] std::string text() const {
    std::string text = file;
    for (const std::size_t number : {line, column}) {
      if (number == 0)
        break;
      text.append(":").append(std::to_string(number));
    }
    return text;
  }
};

class SceneError : public Error {
public:
  SceneError(const SourceLocation& where, const std::string& what)
      : Error(ExitCode::Scene, where.text() + ": " + what) {}
};

} // namespace vkpt
