#include "scene/statements.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vkpt {
namespace {

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  StatementReader reader(text);
  for (Statement s; reader.next(s);) {
    lines.push_back(std::to_string(s.line) + ":" + s.text);
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(Statements, AllLineEndsCountTheSame) {
  const Lines expected{"1:v 1 2 3", "3:f 1 2 3"};
  EXPECT_EQ(linesOf("v 1 2 3\n\nf 1 2 3\n"), expected);
  EXPECT_EQ(linesOf("v 1 2 3\r\n\r\nf 1 2 3\r\n"), expected);
  EXPECT_EQ(linesOf("v 1 2 3\r\rf 1 2 3\r"), expected);
  EXPECT_EQ(linesOf("v 1 2 3\n\nf 1 2 3"), expected) << "no line end at the end";
}

TEST(Statements, BlanksCommentsAndByteOrderMarkAreGone) {
  EXPECT_EQ(linesOf("\xEF\xBB\xBFv 1 2 3 # corner\n \t # all comment\n\tusemtl   a b#1 \t\n"),
            (Lines{"1:v 1 2 3", "3:usemtl a b#1"}));
}

TEST(Statements, ContinuedLinesAreJoinedAndCountedOnce) {
  EXPECT_EQ(linesOf("f 1 2 \\\n 3 4\nv 0 0 0\n"), (Lines{"1:f 1 2  3 4", "3:v 0 0 0"}));
  EXPECT_EQ(linesOf("\\\nv 1 2 3\n\\\n\\\n\\\n# v 4\n"), (Lines{"1:v 1 2 3"}));
}

TEST(Statements, ZeroBytesAreBlanks) {
  EXPECT_EQ(linesOf(std::string_view("v 1\0 2 3\n\0\n", 11)), (Lines{"1:v 1  2 3"}));
}

TEST(Statements, BlanksOfAllKindsSeparateWords) { EXPECT_EQ(linesOf("v\t1\v2\f3"), (Lines{"1:v 1 2 3"})); }

TEST(Statements, CornersLoseTrailingSlashes) {
  EXPECT_EQ(linesOf("f 1/ 2// 3/4/\nmtllib a/\n"), (Lines{"1:f 1 2 3/4", "2:mtllib a/"}));
}

TEST(Numbers, WholeWordsOnly) {
  EXPECT_EQ(parseNumber("-1.5e2"), -150.0);
  EXPECT_EQ(parseNumber("+.5"), 0.5);
  EXPECT_EQ(parseNumber("2."), 2.0);
  EXPECT_EQ(parseNumber("1e-999"), 0.0);
  EXPECT_TRUE(std::isinf(parseNumber("1e999").value()));
  EXPECT_TRUE(std::isnan(parseNumber("nan").value()));
  for (const char* bad :
       {"", "+", "1,5", "1.0f", "1e", "0x10", "++1", "+-1", "one", "1.#IND", "1e-2147483648"}) {
    EXPECT_FALSE(parseNumber(bad)) << bad;
  }
  EXPECT_EQ(parseInteger("-7"), -7);
  for (const char* bad : {"", "1.0", "99999999999", "+-1", "a"}) {
    EXPECT_FALSE(parseInteger(bad)) << bad;
  }
}

} // namespace
} // namespace vkpt
