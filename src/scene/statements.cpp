#include "scene/statements.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace vkpt {

namespace {

constexpr std::string_view kBlanks{" \t\v\f\0", 5};
/// With its letter and sign. tinyobjloader counts exponents in an int.
constexpr std::size_t kLongestExponent = 10;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// tinyobjloader knows two kinds of blank, ends its lines at a zero byte, and takes a second blank before a
/// name for a part of it.
void normalise(std::string& statement) {
  std::ranges::replace_if(
      statement, [](char c) { return kBlanks.find(c) != std::string_view::npos; }, ' ');
  statement.resize(statement.find_last_not_of(' ') + 1);
  const auto keyEnd = statement.find(' ');
  if (keyEnd != std::string::npos) {
    statement.erase(keyEnd + 1, statement.find_first_not_of(' ', keyEnd) - keyEnd - 1);
  }
}

/// Corners may end in slashes (v/, v//). tinyobjloader would read the next corner's number behind them.
void dropTrailingSlashes(std::string& face) {
  std::size_t kept = 0;
  for (const char c : face) {
    while (c == ' ' && kept > 0 && face[kept - 1] == '/') {
      --kept;
    }
    face[kept++] = c;
  }
  face.resize(kept);
  face.resize(face.find_last_not_of('/') + 1);
}

/// Names of files and materials may hold a '#'; numbers may not.
bool holdsNumbers(std::string_view text) { return text.starts_with('v') || text.starts_with('f'); }

} // namespace

std::string_view Statement::key() const { return std::string_view(text).substr(0, text.find(' ')); }

std::string_view Statement::arguments() const {
  const auto blank = text.find(' ');
  return blank == std::string::npos ? std::string_view() : std::string_view(text).substr(blank + 1);
}

StatementReader::StatementReader(std::string_view text) : m_rest(text) {
  if (m_rest.starts_with(kByteOrderMark)) {
    m_rest.remove_prefix(kByteOrderMark.size());
  }
}

std::string_view StatementReader::takeLine() {
  const auto end = std::min(m_rest.find_first_of("\r\n"), m_rest.size());
  const std::string_view line = m_rest.substr(0, end);
  m_rest.remove_prefix(end);
  if (m_rest.starts_with("\r\n")) {
    m_rest.remove_prefix(2);
  } else if (!m_rest.empty()) {
    m_rest.remove_prefix(1);
  }
  ++m_line;
  return line;
}

bool StatementReader::next(Statement& statement) {
  while (!m_rest.empty()) {
    std::string_view line = trim(takeLine());
    if (line.empty() || line.front() == '#') {
      continue;
    }
    statement.line = m_line;
    statement.text.assign(line);
    while (statement.text.ends_with('\\') && !m_rest.empty()) {
      statement.text.back() = ' ';
      statement.text += trim(takeLine());
    }
    statement.text.erase(
        0, statement.text.find_first_not_of(kBlanks)); // of a line that was nothing but a backslash
    if (statement.text.empty() || statement.text.front() == '#') {
      continue;
    }
    if (holdsNumbers(statement.text)) {
      statement.text.resize(std::min(statement.text.find('#'), statement.text.size()));
    }
    normalise(statement.text);
    if (statement.key() == "f") {
      dropTrailingSlashes(statement.text);
    }
    return true;
  }
  return false;
}

StatementBuffer::int_type StatementBuffer::underflow() {
  if (!m_reader.next(m_current)) {
    return traits_type::eof();
  }
  m_chunk.assign(m_current.text).append(1, '\n');
  setg(m_chunk.data(), m_chunk.data(), m_chunk.data() + m_chunk.size());
  return traits_type::to_int_type(m_chunk.front());
}

void splitWords(std::string_view text, std::vector<std::string_view>& words) {
  words.clear();
  while (true) {
    const auto first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos || text[first] == '#') {
      return;
    }
    text.remove_prefix(first);
    const auto end = std::min(text.find_first_of(kBlanks), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::optional<double> parseNumber(std::string_view word) {
  std::string_view digits = word;
  if (digits.starts_with('+') && !digits.starts_with("+-")) {
    digits.remove_prefix(1);
  }
  const auto exponent = digits.find_first_of("eE");
  if (exponent != std::string_view::npos && digits.size() - exponent > kLongestExponent) {
    return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || end != digits.data() + digits.size() || error == std::errc::invalid_argument) {
    return std::nullopt;
  }
  if (error == std::errc::result_out_of_range) {
    const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

std::optional<int> parseInteger(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) {
    word.remove_prefix(1);
  }
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size() || error != std::errc()) {
    return std::nullopt;
  }
  return value;
}

} // namespace vkpt
