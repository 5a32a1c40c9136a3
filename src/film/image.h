#pragma once
// Images in memory and their files: PNG (display-referred), EXR, HDR and PFM (linear).

#include "core/error.h"

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace vkpt {

/// Named float planes, each width * height, row 0 on top. The first three are R, G, B.
struct Image {
  struct Channel {
    std::string name; ///< "R", "stderr.R"
    std::vector<float> values;
  };
  int width = 0;
  int height = 0;
  std::vector<Channel> channels;

  Image() = default;
  /// With the named channels, all 0.
  Image(int width, int height, std::initializer_list<const char*> names);
  [[nodiscard]] std::size_t pixelCount() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// Null where there is none.
  [[nodiscard]] const Channel* find(const std::string& name) const;
  /// Appends a channel of zeros; the reference holds until the next one is added.
  Channel& addChannel(const std::string& name);
};

/// Facts about an image, written as EXR attributes and PNG text, each key behind "vkpt."; .hdr and .pfm carry
/// none. Keys are printable ASCII of at most 74 characters.
using Metadata = std::map<std::string, std::variant<std::string, double, std::int64_t>>;

enum class Tonemap {
  None, ///< linear, clipped to [0, 1]
  Srgb, ///< the sRGB curve (IEC 61966-2-1)
  Aces, ///< Narkowicz's fit of the ACES curve, then the sRGB curve
};

/// For display formats (PNG) only; linear formats are written as they are.
struct DisplaySettings {
  double exposureStops = 0.0; ///< radiance is multiplied by 2^this
  Tonemap tonemap = Tonemap::Srgb;
};

/// Throws UsageError unless `path` has a known extension, its folder exists and can be written to (tried: a
/// file is made and removed), and what stands at `path`, if anything, is a file: to be called before
/// rendering.
void checkOutputPath(const fs::path& path);

/// Writes by extension (.png, .exr, .hdr, .pfm), into a temporary file beside `path` that is then renamed:
/// a failed or interrupted write leaves neither a half-written nor an overwritten file. Throws Error.
///
/// EXR holds every channel as 32-bit floats, ZIP-compressed without loss; strings and doubles of the metadata
/// become attributes of that type, integers `int`, or `string` beyond 32 bits. PFM holds R, G, B bit for bit.
/// HDR holds them rounded to the nearest RGBE: within 1/255 of the pixel's largest channel, negative and NaN
/// as 0, below 1e-32 as 0, clipped at 1.69e38. PNG is rounded to the nearest of 8 bits: below 0 and NaN
/// give 0, above 1 gives 255.
void writeImage(const fs::path& path, const Image& image, const DisplaySettings& display,
                const Metadata& metadata);

/// Reads .exr, .hdr, .pfm and .png by extension. Throws SceneError naming file and reason.
///
/// PNG, of 8 or 16 bits, is decoded from sRGB to linear whatever its gAMA; alpha is dropped. EXR (one part,
/// flat): all channels of the data window, the three colours first; a lone Y gives R = G = B. HDR: divided by
/// its EXPOSURE. PFM: either byte order, colour or grey, times the absolute value of its scale.
Image readImage(const fs::path& path);

} // namespace vkpt
