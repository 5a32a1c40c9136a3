#pragma once
// One pair of functions for each file format. Encoders want an image with R, G and B of a size above 0;
// decoders throw std::exception with the reason, which readImage() puts behind the file's name.

#include "decode/picture.h"
#include "film/file_io.h"
#include "film/image.h"

#include <array>

namespace vkpt::film {

/// The planes R, G and B.
std::array<const float*, 3> colourPlanes(const Image& image);

/// The same pixels with a plane for each of R, G and B.
Image planesOf(const decode::Picture& picture);

/// The format's limit, said before anything is allocated: throws UsageError where stb's `int` sizes would not
/// do.
void checkPngSize(int width, int height);
void checkHdrSize(int width, int height);

void writePng(AtomicFile& out, const Image& image, const DisplaySettings& display, const Metadata& metadata);
void writeExr(AtomicFile& out, const Image& image, const Metadata& metadata);
void writeHdr(AtomicFile& out, const Image& image);
void writePfm(AtomicFile& out, const Image& image);

Image decodePng(ByteView file);
Image decodeExr(ByteView file);
Image decodeHdr(ByteView file);
Image decodePfm(ByteView file);

/// The name under which a fact is written.
inline std::string metadataName(const std::string& key) { return "vkpt." + key; }

using decode::FormatError;

} // namespace vkpt::film
