// PFM (portable float map, P. Debevec): a header of three lines, then floats from the bottom row up.

#include "film/codecs.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

namespace vkpt::film {

namespace {

static_assert(std::endian::native == std::endian::little, "PFM is written in the machine's own byte order");

/// The header's words; it ends with the single white space behind the third number.
class Header {
public:
  explicit Header(ByteView file) : m_text(reinterpret_cast<const char*>(file.data()), file.size()) {}

  std::string_view word() {
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t begin = std::min(m_text.find_first_not_of(kSpace, m_end), m_text.size());
    m_end = std::min(m_text.find_first_of(kSpace, begin), m_text.size());
    return m_text.substr(begin, m_end - begin);
  }
  template<class T>
  T number(const char* what) {
    const std::string_view w = word();
    T value{};
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
    if (error != std::errc{} || end != w.data() + w.size())
      throw FormatError(fmt::format("broken PFM: no {} in its header", what));
    return value;
  }
  [[nodiscard]] std::size_t end() const { return std::min(m_end + 1, m_text.size()); }

private:
  std::string_view m_text;
  std::size_t m_end = 0;
};

float floatAt(const unsigned char* bytes, bool bigEndian) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, bytes, sizeof bits);
  return std::bit_cast<float>(bigEndian ? __builtin_bswap32(bits) : bits);
}

} // namespace

void writePfm(AtomicFile& out, const Image& image) {
  const auto planes = colourPlanes(image);
  const std::string header = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
  out.write({reinterpret_cast<const unsigned char*>(header.data()), header.size()});
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<float> row(3 * width);
  for (auto y = static_cast<std::size_t>(image.height); y-- > 0;) {
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        row[3 * x + c] = planes[c][y * width + x];
    out.write({reinterpret_cast<const unsigned char*>(row.data()), row.size() * sizeof(float)});
  }
}

Image decodePfm(ByteView file) {
  Header header(file);
  const std::string_view kind = header.word();
  if (kind != "PF" && kind != "Pf")
    throw FormatError("is no PFM file");
  const std::size_t components = kind == "PF" ? 3 : 1;
  const int width = header.number<int>("width"), height = header.number<int>("height");
  const auto scale = header.number<double>("scale");
  if (width < 1 || height < 1)
    throw FormatError(fmt::format("broken PFM: a size of {}x{}", width, height));
  if (!std::isfinite(scale) || scale == 0.0)
    throw FormatError("broken PFM: a scale that is zero or not finite");
  const ByteView data = file.subspan(header.end());
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  if (w * h > data.size() / (components * sizeof(float)))
    throw FormatError("broken PFM: the file ends too soon");

  Image image(width, height, {"R", "G", "B"});
  const bool bigEndian = scale > 0.0;
  const auto factor = static_cast<float>(std::abs(scale));
  for (std::size_t i = 0; i < w * h; ++i) {
    const std::size_t row = h - 1 - i / w;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t component = i * components + (components == 3 ? c : 0);
      const float v = floatAt(data.data() + component * sizeof(float), bigEndian);
      image.channels[c].values[row * w + i % w] = factor == 1.0F ? v : v * factor;
    }
  }
  return image;
}

} // namespace vkpt::film
