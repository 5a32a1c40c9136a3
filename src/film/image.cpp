#include "film/image.h"

#include "film/codecs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <new>
#include <optional>
#include <string_view>

namespace vkpt {

Image::Image(int width_, int height_, std::initializer_list<const char*> names)
    : width(width_), height(height_) {
  channels.reserve(names.size());
  for (const char* name : names)
    addChannel(name);
}

const Image::Channel* Image::find(const std::string& name) const {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == name; });
  return found == channels.end() ? nullptr : &*found;
}

Image::Channel& Image::addChannel(const std::string& name) {
  return channels.emplace_back(Channel{name, std::vector<float>(pixelCount())});
}

namespace film {

std::array<const float*, 3> colourPlanes(const Image& image) {
  std::array<const float*, 3> planes{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Image::Channel* channel = image.find(std::string(1, "RGB"[c]));
    assert(channel != nullptr && channel->values.size() == image.pixelCount());
    planes[c] = channel->values.data();
  }
  return planes;
}

Image planesOf(const decode::Picture& picture) {
  Image image(picture.width, picture.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      image.channels[c].values[i] = picture.rgb[3 * i + c];
  return image;
}

} // namespace film

namespace {

enum class Format { Png, Exr, Hdr, Pfm };
constexpr std::string_view kKnownFormats = "use .png, .exr, .hdr or .pfm";

/// By extension, of upper or lower case.
std::optional<Format> formatOf(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') // tolower() depends on the locale
      c = static_cast<char>(c - 'A' + 'a');
  if (extension == ".png")
    return Format::Png;
  if (extension == ".exr")
    return Format::Exr;
  if (extension == ".hdr")
    return Format::Hdr;
  if (extension == ".pfm")
    return Format::Pfm;
  return std::nullopt;
}

Format outputFormat(const fs::path& path) {
  const std::optional<Format> format = formatOf(path);
  if (!format)
    throw UsageError(fmt::format("{}: unknown image format; {}", path.string(), kKnownFormats));
  return *format;
}

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Image decodeAs(Format format, film::ByteView file) {
  switch (format) {
  case Format::Png:
    return film::decodePng(file);
  case Format::Exr:
    return film::decodeExr(file);
  case Format::Hdr:
    return film::decodeHdr(file);
  case Format::Pfm:
    break;
  }
  return film::decodePfm(file);
}

void encode(Format format, film::AtomicFile& out, const Image& image, const DisplaySettings& display,
            const Metadata& metadata) {
  switch (format) {
  case Format::Png:
    return film::writePng(out, image, display, metadata);
  case Format::Exr:
    return film::writeExr(out, image, metadata);
  case Format::Hdr:
    return film::writeHdr(out, image);
  case Format::Pfm:
    return film::writePfm(out, image);
  }
}

} // namespace

void checkOutputPath(const fs::path& path) {
  outputFormat(path);
  const film::AtomicFile trial(path); // not committed: removed again
}

void writeImage(const fs::path& path, const Image& image, const DisplaySettings& display,
                const Metadata& metadata) {
  const Format format = outputFormat(path);
  if (image.width < 1 || image.height < 1)
    throw UsageError(fmt::format("{}: an image of {}x{} pixels cannot be written; the least is 1x1",
                                 path.string(), image.width, image.height));
  film::AtomicFile out(path);
  try {
    encode(format, out, image, display, metadata);
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::Usage, path.string() + ": cannot be written: not enough memory");
  } catch (const std::exception& e) { // of the codec
    throw Error(ExitCode::Usage, fmt::format("{}: cannot be written: {}", path.string(), oneLine(e.what())));
  }
  out.commit();
}

Image readImage(const fs::path& path) {
  const std::optional<Format> format = formatOf(path);
  if (!format)
    throw SceneError({path.string()}, fmt::format("unknown image format; {}", kKnownFormats));
  try {
    const film::Bytes file = film::readWholeFile(path);
    return decodeAs(*format, file);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw SceneError({path.string()}, "not enough memory to read this image");
  } catch (const std::exception& e) {
    throw SceneError({path.string()}, oneLine(e.what()));
  }
}

} // namespace vkpt
