#pragma once
// What OpenEXR (3.1) does not check before it allocates.

#include "film/codecs.h"

#include <OpenEXR/ImfHeader.h>

#include <cstdint>

namespace vkpt::film {

inline constexpr std::size_t kFirstExrAttribute = 8; ///< behind magic number and version

/// The attributes' sizes are those of their types, and within the file. Gives the version with its flags.
/// Throws FormatError.
int checkExrAttributes(ByteView file);

/// Whether a file of that many bytes can hold the image, by what its compression can make of a byte.
bool exrFileJustifies(std::size_t bytes, const Imf::Header& header, std::int64_t width, std::int64_t height);

} // namespace vkpt::film
