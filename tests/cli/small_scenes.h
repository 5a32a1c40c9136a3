#pragma once
// OBJ files that show something: the smallest, and some that trees are bad at.

#include <string>

namespace vkpt::test {

/// A unit square in the plane z = 0 that faces +z, where the fitted camera is.
inline const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
/// A white background gives light; with it a grey surface of albedo 0.8 has the radiance 0.8.
inline const std::string kWhite = "1,1,1";

/// As many triangles as said, in the plane z = 0, each a little larger than the last: all centroids are one.
std::string concentric(int count);
/// One triangle, as many times.
std::string identical(int count);
/// As many triangles at one point, beside kSquare.
std::string atOnePoint(int count);
/// Slivers about one point.
std::string sliverFan(int count);
/// A wavy sheet of 2 n^2 triangles.
std::string waves(int n);

} // namespace vkpt::test
