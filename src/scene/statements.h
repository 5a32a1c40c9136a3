#pragma once
// OBJ and MTL texts as statements: one logical line each, with the number of the line it starts on.

#include <cstddef>
#include <optional>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt {

/// "key rest": one blank behind the key, none at either end, continued lines joined, comments gone.
struct Statement {
  std::size_t line = 0; ///< where it starts, counted from 1
  std::string text;

  [[nodiscard]] std::string_view key() const;
  [[nodiscard]] std::string_view arguments() const;
};

/// Walks a text with any line ends (LF, CRLF, CR), with or without the last one.
class StatementReader {
public:
  explicit StatementReader(std::string_view text);
  /// False at the end of the text.
  bool next(Statement& statement);

private:
  std::string_view takeLine();

  std::string_view m_rest;
  std::size_t m_line = 0;
};

/// Feeds statements to tinyobjloader one at a time, so that its callbacks can ask which line they are about.
class StatementBuffer : public std::streambuf {
public:
  explicit StatementBuffer(std::string_view text) : m_reader(text) {}
  [[nodiscard]] const Statement& current() const { return m_current; }

protected:
  int_type underflow() override;

private:
  StatementReader m_reader;
  Statement m_current;
  std::string m_chunk;
};

/// The blank-separated words of `text`, up to a word that starts a comment.
void splitWords(std::string_view text, std::vector<std::string_view>& words);

/// A whole word as a number; `nan` and `inf` count as numbers, too large ones as infinite. Empty: not a
/// number, or one with an exponent of nine digits and more.
std::optional<double> parseNumber(std::string_view word);

/// A whole word as an integer that fits.
std::optional<int> parseInteger(std::string_view word);

} // namespace vkpt
