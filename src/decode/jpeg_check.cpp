#include "decode/jpeg_check.h"

namespace vkpt::decode {

namespace {

constexpr unsigned char kMark = 0xFF;
constexpr unsigned char kStart = 0xD8;
constexpr unsigned char kHuffmanTables = 0xC4;
constexpr unsigned char kComment = 0xFE;
constexpr unsigned char kFirstApp = 0xE0;
constexpr unsigned char kLastApp = 0xEF;

std::size_t bigEndian(ByteView file, std::size_t at) { return file[at] * std::size_t{256} + file[at + 1]; }

/// Behind the comments and the data of applications at the start: these may hold any bytes.
std::size_t skipForeign(ByteView file) {
  std::size_t at = 2;
  while (at + 4 <= file.size() && file[at] == kMark &&
         (file[at + 1] == kComment || (file[at + 1] >= kFirstApp && file[at + 1] <= kLastApp)) &&
         bigEndian(file, at + 2) >= 2) {
    at += 2 + bigEndian(file, at + 2);
  }
  return at;
}

/// `at`: the length of a segment of tables.
void checkTables(ByteView file, std::size_t at) {
  constexpr std::size_t kLengths = 16;
  constexpr std::size_t kMostCodes = 256;
  if (at + 2 > file.size())
    return;
  const std::size_t end = at + bigEndian(file, at);
  at += 2;
  while (at < end && at < file.size()) {
    std::size_t codes = 0; // stb goes on behind the end of the file, in zeros
    for (std::size_t i = at + 1; i <= at + kLengths && i < file.size(); ++i)
      codes += file[i];
    if (codes > kMostCodes)
      throw FormatError("broken JPEG: a Huffman table of more than 256 codes");
    at += 1 + kLengths + codes;
  }
}

} // namespace

void checkJpeg(ByteView file) {
  if (file.size() >= 2 && file[0] == kMark && file[1] == kMark) // stb reads over fill bytes here
    throw FormatError("broken JPEG: it does not start with FF D8");
  if (file.size() < 2 || file[0] != kMark || file[1] != kStart)
    return;
  // Wherever these two bytes stand: a reader that has lost its way can take them for a marker.
  for (std::size_t i = skipForeign(file); i + 1 < file.size(); ++i) {
    if (file[i] == kMark && file[i + 1] == kHuffmanTables)
      checkTables(file, i + 2);
  }
}

} // namespace vkpt::decode
