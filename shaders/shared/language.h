// What it takes for the shader library (shaders/lib/*.glsl) to compile as GLSL and as C++ from one text.
//
// GLSL: included by every .comp file. C++: included inside `namespace vkpt::host32` (Float = float) and
// `vkpt::host64` (Float = double) by src/host/program.h; the library itself is then included inside a class,
// so that its functions become members and its accessors read host buffers.
//
// Rules for the library: literals are plain (`0.5`; the C++ float program is compiled with
// -fsingle-precision-constant), no swizzles of more than one component (xyz(v)), no array parameters, no two
// random numbers in one expression (order of evaluation differs), no aliased INOUT arguments.
#ifdef __cplusplus

#define INOUT(T) T&
#define OUT(T) T&
#define precise
#define CONSTANT static constexpr
using Vec2 = glm::vec<2, Float>;
using Vec3 = glm::vec<3, Float>;
using Vec4 = glm::vec<4, Float>;
using UVec4 = glm::uvec4;
using uint = unsigned int;
using glm::abs, glm::all, glm::any, glm::atan, glm::clamp, glm::cos, glm::cross, glm::dot, glm::exp,
    glm::floor, glm::length, glm::log, glm::max, glm::min, glm::mix, glm::normalize, glm::pow, glm::sin,
    glm::sqrt;
inline Vec3 xyz(const Vec4& v) { return Vec3(v.x, v.y, v.z); }
inline bool isFinite(Float x) { return std::isfinite(x); }
inline bool allFinite(const Vec3& v) { return isFinite(v.x) && isFinite(v.y) && isFinite(v.z); }
/// Monotonic in x >= 0; orders children, so float precision is enough in every program.
inline uint orderKey(Float x) { return std::bit_cast<uint>(static_cast<float>(x)); }
inline Vec4 slabMin(const Vec4& a, const Vec4& b) { return glm::min(a, b); }
inline Vec4 slabMax(const Vec4& a, const Vec4& b) { return glm::max(a, b); }
inline uint subgroupMaximum(uint x) { return x; }
inline uint reverseBits(uint v) { return static_cast<uint>(glm::bitfieldReverse(v)); }
inline uint multiplyHigh(uint a, uint b) {
  return static_cast<uint>((static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b)) >> 32U);
}
/// Distance from 1 to the next number: the unit of the error bounds.
inline constexpr Float kSplitter =
    static_cast<Float>((1ULL << ((std::numeric_limits<Float>::digits + 1) / 2)) + 1ULL);
inline constexpr Float kEpsilon = std::numeric_limits<Float>::epsilon();

#else

#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#define INOUT(T) inout T
#define OUT(T) out T
#define CONSTANT const
const float kSplitter = 4097.0;
#define Float float
#define Vec2 vec2
#define Vec3 vec3
#define Vec4 vec4
#define UVec4 uvec4
vec3 xyz(vec4 v) { return v.xyz; }
// By bit pattern: isnan() and isinf() may be assumed away by a driver.
bool isFinite(float x) { return (floatBitsToUint(x) & 0x7F800000u) != 0x7F800000u; }
bool allFinite(vec3 v) { return isFinite(v.x) && isFinite(v.y) && isFinite(v.z); }
uint orderKey(float x) { return floatBitsToUint(x); }
// Minimum and maximum of distances along a ray, by their bits as integers: one instruction where NaN rules
// cost three. Numbers below 0 only stay below 0, which is all that a slab test needs.
vec4 slabMin(vec4 a, vec4 b) { return intBitsToFloat(min(floatBitsToInt(a), floatBitsToInt(b))); }
vec4 slabMax(vec4 a, vec4 b) { return intBitsToFloat(max(floatBitsToInt(a), floatBitsToInt(b))); }
uint subgroupMaximum(uint x) { return subgroupMax(x); }
uint reverseBits(uint v) { return bitfieldReverse(v); }
uint multiplyHigh(uint a, uint b) {
  uint high;
  uint low;
  umulExtended(a, b, high, low);
  return high;
}
const float kEpsilon = 1.1920929e-7;

#endif

#include "shared/mutations.h"
