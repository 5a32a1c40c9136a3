#pragma once
// The smallest OBJ files that show something.

#include <string>

namespace vkpt::test {

/// A unit square in the plane z = 0 that faces +z, where the fitted camera is.
inline const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// A white background gives light; with it a grey surface of albedo 0.8 has the radiance 0.8.
inline const std::string kWhite = "1,1,1";

} // namespace vkpt::test
