#pragma once
// What vkpt makes of an MTL file: the one table of keys, the one of `illum` and the one of metals. The
// warnings are made from them, and the documentation is to be.

#include "core/math.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace vkpt {

enum class MtlValue { Name, Colour, Number, Integer, Text };

enum class MtlUse {
  Read,   ///< has an effect
  Silent, ///< has none, and nobody misses it
  Ignored ///< has none, which a warning says unless the value is neutral
};

struct MtlKey {
  std::string_view key;
  MtlValue value;
  MtlUse use;
  std::string_view meaning;        ///< in the MTL format
  std::string_view mapping;        ///< what vkpt makes of it
  std::optional<double> neutral{}; ///< of an ignored key: the value that means the same as no key
};

// clang-format off
inline constexpr std::array kMtlKeys{
    MtlKey{"newmtl", MtlValue::Name, MtlUse::Read, "starts a material", "its name; also chooses the metal for illum 11"},
    MtlKey{"illum", MtlValue::Integer, MtlUse::Read, "illumination model", "chooses the shader, see kIllumModels; absent: 2"},
    MtlKey{"Kd", MtlValue::Colour, MtlUse::Read, "diffuse colour", "albedo, linear RGB, not clamped; illum 12: light left after one unit of length is exp(1 - 1 / Kd); absent: 0.8"},
    MtlKey{"Ks", MtlValue::Colour, MtlUse::Read, "specular colour", "strength of the Phong lobe of illum 2; tints a metal that is in no table; else without effect"},
    MtlKey{"Ke", MtlValue::Colour, MtlUse::Read, "emission", "radiance of the front side; where it is above 0, Ka is not emission"},
    MtlKey{"Ka", MtlValue::Colour, MtlUse::Read, "ambient colour", "radiance of the front side where Kd is 0 in all channels or a channel of Ka is above 1; else without effect"},
    MtlKey{"Ni", MtlValue::Number, MtlUse::Read, "index of refraction", "of the inside of a dielectric, air outside; absent: 1.5"},
    MtlKey{"Ns", MtlValue::Number, MtlUse::Read, "specular exponent", "of the Phong lobe of illum 2, 0 to 1e6; absent: 0, with a warning; else without effect"},
    MtlKey{"sharpness", MtlValue::Number, MtlUse::Silent, "of local reflection maps", "without effect"},
    MtlKey{"Tf", MtlValue::Colour, MtlUse::Ignored, "transmission filter", "not read: light passes unfiltered", 1.0},
    MtlKey{"Kt", MtlValue::Colour, MtlUse::Ignored, "transmission colour", "not read: light passes unfiltered", 1.0},
    MtlKey{"d", MtlValue::Number, MtlUse::Ignored, "opacity", "not read: the surface is opaque", 1.0},
    MtlKey{"Tr", MtlValue::Number, MtlUse::Ignored, "transparency", "not read: the surface is opaque", 0.0},
    MtlKey{"map_Kd", MtlValue::Text, MtlUse::Read, "texture of Kd", "PNG, JPEG, BMP, TGA (sRGB) or HDR (linear), multiplies Kd of illum 0, 1, 2; options are not used"},
    MtlKey{"map_Ks", MtlValue::Text, MtlUse::Ignored, "texture of Ks", "not read: Ks holds everywhere"},
    MtlKey{"map_Ka", MtlValue::Text, MtlUse::Ignored, "texture of Ka", "not read: Ka holds everywhere"},
    MtlKey{"map_Ke", MtlValue::Text, MtlUse::Ignored, "texture of Ke", "not read: Ke holds everywhere"},
    MtlKey{"map_Ns", MtlValue::Text, MtlUse::Ignored, "texture of Ns", "not read"},
    MtlKey{"map_d", MtlValue::Text, MtlUse::Ignored, "texture of d", "not read: the surface is opaque"},
    MtlKey{"map_bump", MtlValue::Text, MtlUse::Ignored, "bump map", "not read: the surface is smooth"},
    MtlKey{"map_Bump", MtlValue::Text, MtlUse::Ignored, "bump map", "not read: the surface is smooth"},
    MtlKey{"bump", MtlValue::Text, MtlUse::Ignored, "bump map", "not read: the surface is smooth"},
    MtlKey{"norm", MtlValue::Text, MtlUse::Ignored, "normal map", "not read: the surface is smooth"},
    MtlKey{"disp", MtlValue::Text, MtlUse::Ignored, "displacement map", "not read: the surface is smooth"},
    MtlKey{"decal", MtlValue::Text, MtlUse::Ignored, "decal texture", "not read"},
    MtlKey{"refl", MtlValue::Text, MtlUse::Ignored, "reflection map", "not read: reflections are traced"},
    MtlKey{"Pr", MtlValue::Number, MtlUse::Ignored, "roughness", "not read: illum chooses the shader", 0.0},
    MtlKey{"Pm", MtlValue::Number, MtlUse::Ignored, "metalness", "not read: illum chooses the shader", 0.0},
    MtlKey{"Ps", MtlValue::Number, MtlUse::Ignored, "sheen", "not read: illum chooses the shader", 0.0},
    MtlKey{"Pc", MtlValue::Number, MtlUse::Ignored, "clearcoat thickness", "not read: illum chooses the shader", 0.0},
    MtlKey{"Pcr", MtlValue::Number, MtlUse::Ignored, "clearcoat roughness", "not read: illum chooses the shader", 0.0},
    MtlKey{"aniso", MtlValue::Number, MtlUse::Ignored, "anisotropy", "not read: illum chooses the shader", 0.0},
    MtlKey{"anisor", MtlValue::Number, MtlUse::Ignored, "rotation of the anisotropy", "not read: illum chooses the shader", 0.0},
    MtlKey{"map_Pr", MtlValue::Text, MtlUse::Ignored, "texture of Pr", "not read: illum chooses the shader"},
    MtlKey{"map_Pm", MtlValue::Text, MtlUse::Ignored, "texture of Pm", "not read: illum chooses the shader"},
    MtlKey{"map_Ps", MtlValue::Text, MtlUse::Ignored, "texture of Ps", "not read: illum chooses the shader"},
};
// clang-format on

enum class MtlShader { Diffuse, Phong, Mirror, Dielectric, Metal, Absorbing };

struct IllumModel {
  int illum;
  MtlShader shader;
  std::string_view meaning; ///< in the assignment's framework, where it has one
};

/// Every other number is unknown: diffuse, with a warning.
inline constexpr std::array kIllumModels{
    IllumModel{0, MtlShader::Diffuse, "diffuse"},
    IllumModel{1, MtlShader::Diffuse, "diffuse"},
    IllumModel{2, MtlShader::Phong, "diffuse with Phong highlights; diffuse where Ks is 0"},
    IllumModel{3, MtlShader::Mirror, "mirror of reflectance 1"},
    IllumModel{4, MtlShader::Dielectric, "glass"},
    IllumModel{6, MtlShader::Dielectric, "glass (MTL: refraction)"},
    IllumModel{7, MtlShader::Dielectric, "glass (MTL: refraction with Fresnel)"},
    IllumModel{11, MtlShader::Metal, "metal with the complex index of its name, see kMetals"},
    IllumModel{12, MtlShader::Absorbing, "glass that absorbs"},
};

/// Refraction n - ik per RGB channel.
struct Metal {
  std::string_view name;
  Vec3f eta;
  Vec3f k;
};

/// Silver: Glassner's n and k from 380 to 775 nm, averaged with the Stockman-Sharpe RGB matching functions.
/// Gold and copper: k near red, green and blue light's, n such that the normal reflectance
/// ((n-1)^2+k^2)/((n+1)^2+k^2) is what the same averages give: (.935,.753,.387) and (.854,.646,.549).
inline constexpr std::array kMetals{
    Metal{"silver", {0.126136F, 0.126423F, 0.150656F}, {3.803187F, 3.244109F, 2.453368F}},
    Metal{"gold", {0.284611F, 0.488326F, 1.017676F}, {3.983F, 2.386F, 1.603F}},
    Metal{"copper", {0.659051F, 0.827733F, 0.942955F}, {3.912F, 2.452F, 2.142F}},
};

const MtlKey* findMtlKey(std::string_view key);
const IllumModel* findIllumModel(int illum);
/// By a material's name, in any case, without a modeller's number (`Silver.001`).
const Metal* findMetal(std::string_view materialName);

} // namespace vkpt
