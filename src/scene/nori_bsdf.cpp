#include "scene/nori_bsdf.h"

#include "scene/limits.h"
#include "scene/mtl_table.h"
#include "scene/names.h"
#include "scene/nori_object.h"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vkpt {

namespace {

constexpr double kDefaultIntIor = 1.5046;   // BK7
constexpr double kDefaultExtIor = 1.000277; // air
constexpr double kDefaultAlpha = 0.1;

constexpr NoriRule kReflectance{"0 to 1e12", [](double x) { return x >= 0.0 && x <= kLargestColour; }};
constexpr NoriRule kShare{"0 to 1: the rest is specular", [](double x) { return x >= 0.0 && x <= 1.0; }};
constexpr NoriRule kIor{"1e-6 to 1e6; glass has 1.5",
                        [](double x) { return x >= kLeastIor && x <= kLargestIor; }};
constexpr NoriRule kEta{"1e-6 to 1e6", [](double x) { return x >= kLeastIor && x <= kLargestIor; }};
constexpr NoriRule kExtinction{"0 to 1e6", [](double x) { return x >= 0.0 && x <= kLargestIor; }};
constexpr NoriRule kExponent{"0 to 1e6", [](double x) { return x >= 0.0 && x <= 1e6; }};
constexpr NoriRule kCoatAlpha{"1e-4 to 10", [](double x) { return x >= kLeastRoughness && x <= 10.0; }};
constexpr NoriRule kAlpha{"0 (smooth) to 10", [](double x) { return x >= 0.0 && x <= 10.0; }};

/// `sum` is what the surface reflects at most; sums of decimals may exceed 1 by their rounding.
void warnOfGain(const NoriObject& object, std::string_view name, const Vec3d& sum) {
  if (maxComponent(sum) > 1.0 + kSumRounding) {
    object.warn(object.where(name),
                fmt::format("{} {} {} {} is above 1: it reflects more light than it gets; kept", name,
                            shortNumber(sum.x), shortNumber(sum.y), shortNumber(sum.z)));
  }
}

void readDiffuse(NoriObject& object, Material& out) {
  const Vec3d albedo = object.colour("albedo", kReflectance, 0.5);
  warnOfGain(object, "albedo", albedo);
  out.bsdf = BsdfType::Diffuse;
  out.reflectance = Vec3f(albedo);
}

void readPhong(NoriObject& object, Material& out) {
  const Vec3d kd = object.colour("kd", kReflectance, 0.5);
  const Vec3d ks = object.colour("ks", kReflectance, 0.5);
  out.bsdf = BsdfType::Phong;
  out.reflectance = Vec3f(kd);
  out.specular = Vec3f(ks);
  out.exponent = static_cast<float>(object.number("n", kExponent, 20.0));
  warnOfGain(object, "kd + ks", kd + ks);
}

void readMirror(NoriObject& object, Material& out) {
  const Vec3d reflectance = object.colour("reflectance", kReflectance, 1.0);
  warnOfGain(object, "reflectance", reflectance);
  out.bsdf = BsdfType::Mirror;
  out.reflectance = Vec3f(reflectance);
}

void readIors(NoriObject& object, Material& out) {
  out.intIor = static_cast<float>(object.number("intIOR", kIor, kDefaultIntIor));
  out.extIor = static_cast<float>(object.number("extIOR", kIor, kDefaultExtIor));
}

void readDielectric(NoriObject& object, Material& out) {
  out.bsdf = BsdfType::Dielectric;
  out.twoSided = true;
  out.reflectance = Vec3f(1.0F);
  readIors(object, out);
  out.absorption = Vec3f(object.colour("absorption", kReflectance, 0.0));
}

void readMicrofacet(NoriObject& object, Material& out) {
  const Vec3d kd = object.colour("kd", kShare, 0.5);
  out.bsdf = BsdfType::Microfacet;
  out.reflectance = Vec3f(kd);
  out.specular = Vec3f(static_cast<float>(1.0 - maxComponent(kd)));
  out.roughness = static_cast<float>(object.number("alpha", kCoatAlpha, kDefaultAlpha));
  out.distribution = MicrofacetDistribution::Beckmann;
  readIors(object, out);
}

void readMetal(NoriObject& object, Material& out) {
  const auto name = object.text("material");
  const auto eta = object.colour("eta", kEta);
  const auto k = object.colour("k", kExtinction);
  std::vector<std::string_view> known;
  std::ranges::transform(kMetals, std::back_inserter(known), &Metal::name);
  if (name.has_value() == (eta && k) || eta.has_value() != k.has_value()) {
    throw SceneError(object.where(), fmt::format("which metal? give either material ({}) or both eta and k",
                                                 fmt::join(known, ", ")));
  }
  const Metal* metal = name ? findMetal(*name) : nullptr;
  if (name && metal == nullptr) {
    throw SceneError(object.where("material"),
                     fmt::format("unknown material '{}'; vkpt knows {}{}; or give eta and k", shown(*name),
                                 fmt::join(known, ", "), didYouMean(*name, known)));
  }
  out.bsdf = BsdfType::Conductor;
  out.reflectance = Vec3f(1.0F);
  out.eta = metal != nullptr ? metal->eta : Vec3f(*eta);
  out.k = metal != nullptr ? metal->k : Vec3f(*k);
}

/// Changes the smooth `out` into `rough`, unless its alpha makes no difference.
void roughen(NoriObject& object, Material& out, BsdfType rough) {
  static constexpr std::array<std::string_view, 2> kNames{"ggx", "beckmann"};
  const double alpha = object.number("alpha", kAlpha, kDefaultAlpha);
  const std::string name = object.text("distribution").value_or("ggx");
  if (name != kNames[0] && name != kNames[1]) {
    throw SceneError(object.where("distribution"),
                     fmt::format("unknown distribution '{}'; give ggx or beckmann{}", shown(name),
                                 didYouMean(name, kNames)));
  }
  if (alpha < kLeastRoughness) {
    return;
  }
  out.bsdf = rough;
  out.roughness = static_cast<float>(alpha);
  out.distribution = name == kNames[0] ? MicrofacetDistribution::Ggx : MicrofacetDistribution::Beckmann;
}

void readRoughMetal(NoriObject& object, Material& out) {
  readMetal(object, out);
  roughen(object, out, BsdfType::RoughConductor);
}

void readRoughDielectric(NoriObject& object, Material& out) {
  readDielectric(object, out);
  roughen(object, out, BsdfType::RoughDielectric);
}

struct NoriBsdf {
  std::string_view type;
  void (*read)(NoriObject&, Material&);
};

constexpr std::array kBsdfs{
    NoriBsdf{"diffuse", readDiffuse},
    NoriBsdf{"phong", readPhong},
    NoriBsdf{"mirror", readMirror},
    NoriBsdf{"dielectric", readDielectric},
    NoriBsdf{"microfacet", readMicrofacet},
    NoriBsdf{"conductor", readMetal},
    NoriBsdf{"roughconductor", readRoughMetal},
    NoriBsdf{"roughdielectric", readRoughDielectric},
};

} // namespace

Material readNoriBsdf(const XmlElement& bsdf, SceneReport& report) {
  const NoriBsdf& entry = noriTypeEntry(bsdf, kBsdfs);
  NoriObject object(bsdf, {}, report);
  Material material = defaultNoriMaterial();
  material.name = entry.type;
  material.where = bsdf.where;
  entry.read(object, material);
  object.warnOfUnread();
  return material;
}

Material defaultNoriMaterial() {
  Material material;
  material.name = "diffuse";
  material.twoSided = false;
  return material;
}

} // namespace vkpt
