// Radiance RGBE (G. Ward 1991, "Real Pixels", Graphics Gems II), read by hand.

#include "decode/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace vkpt::decode {

namespace {

constexpr int kMantissaBits = 8;
constexpr int kExponentBias = 128;

/// Takes the file apart from its beginning.
class Reader {
public:
  explicit Reader(ByteView file) : m_rest(file) {}

  [[nodiscard]] std::size_t left() const { return m_rest.size(); }
  std::string_view line() {
    const auto end = std::find(m_rest.begin(), m_rest.end(), '\n');
    if (end == m_rest.end())
      throw FormatError("broken HDR: the file ends in its header");
    const auto size = static_cast<std::size_t>(end - m_rest.begin());
    const std::string_view text(reinterpret_cast<const char*>(m_rest.data()), size);
    m_rest = m_rest.subspan(size + 1);
    return text;
  }
  ByteView take(std::size_t count) {
    if (count > m_rest.size())
      throw FormatError("broken HDR: the file ends too soon");
    const ByteView bytes = m_rest.first(count);
    m_rest = m_rest.subspan(count);
    return bytes;
  }
  /// A row that starts with these four bytes is run-length coded.
  [[nodiscard]] bool startsRuns(std::size_t width) const {
    return width >= 8 && width < 32768 && m_rest.size() >= 4 && m_rest[0] == 2 && m_rest[1] == 2 &&
           m_rest[2] * std::size_t{256} + m_rest[3] == width;
  }

private:
  ByteView m_rest;
};

double parseNumber(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || !(value > 0.0) || !std::isfinite(value))
    throw FormatError("broken HDR: its EXPOSURE is no positive number");
  return value;
}

/// Reads up to the empty line; gives the product of the exposures that the pixels were multiplied by.
double readHeader(Reader& in) {
  const std::string_view magic = in.left() >= 2 ? in.line() : std::string_view();
  if (!magic.starts_with("#?"))
    throw FormatError("is no Radiance HDR file");
  double exposure = 1.0;
  for (std::string_view text = in.line(); !text.empty(); text = in.line()) {
    if (text.starts_with("FORMAT=") && !text.starts_with("FORMAT=32-bit_rle_rgbe"))
      throw FormatError(fmt::format("HDR of {}; only 32-bit_rle_rgbe can be read", text.substr(0, 40)));
    if (text.starts_with("EXPOSURE="))
      exposure *= parseNumber(text.substr(9));
  }
  return exposure;
}

/// "-Y 480 +X 640": rows from the top, columns from the left.
void readSize(Reader& in, int& width, int& height) {
  const std::string_view text = in.line();
  const auto number = [&](std::string_view axis, std::size_t from, int& value) {
    if (text.size() < from || !text.substr(from).starts_with(axis))
      throw FormatError("broken HDR: its size does not read \"-Y height +X width\"");
    const auto result = std::from_chars(text.data() + from + axis.size(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || value < 1)
      throw FormatError("broken HDR: its size is no positive number");
    return static_cast<std::size_t>(result.ptr - text.data());
  };
  number(" +X ", number("-Y ", 0, height), width);
}

/// One row, as four planes (R, G, B, exponent) of `width` bytes.
void readRow(Reader& in, std::size_t width, Bytes& row) {
  if (!in.startsRuns(width)) {
    for (std::size_t x = 0; x < width; ++x) {
      const ByteView pixel = in.take(4);
      for (std::size_t c = 0; c < 4; ++c)
        row[c * width + x] = pixel[c];
    }
    return;
  }
  in.take(4);
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t x = 0; x < width;) {
      const std::size_t code = in.take(1)[0];
      const std::size_t count = code > 128 ? code - 128 : code;
      if (count == 0 || count > width - x)
        throw FormatError("broken HDR: a run of a wrong length");
      const auto to = row.begin() + static_cast<std::ptrdiff_t>(c * width + x);
      if (code > 128)
        std::fill_n(to, count, in.take(1)[0]);
      else
        std::ranges::copy(in.take(count), to);
      x += count;
    }
  }
}

} // namespace

Picture decodeHdr(ByteView file) {
  Reader in(file);
  const double exposure = readHeader(in);
  Picture picture;
  readSize(in, picture.width, picture.height);
  const auto w = static_cast<std::size_t>(picture.width), h = static_cast<std::size_t>(picture.height);
  constexpr std::size_t kMostPixelsPerByte = 16; // a run of 127 in each of four planes takes 8 bytes
  if (w * h / kMostPixelsPerByte > in.left())
    throw FormatError("broken HDR: the file ends too soon");

  picture.rgb.resize(3 * w * h);
  Bytes row(4 * w);
  for (std::size_t y = 0; y < h; ++y) {
    readRow(in, w, row);
    for (std::size_t x = 0; x < w; ++x) {
      const int exponent = row[3 * w + x];
      const double unit = exponent == 0 ? 0.0 : std::ldexp(1.0, exponent - kExponentBias - kMantissaBits);
      for (std::size_t c = 0; c < 3; ++c)
        picture.rgb[3 * (y * w + x) + c] = static_cast<float>(row[c * w + x] * unit / exposure);
    }
  }
  return picture;
}

} // namespace vkpt::decode
