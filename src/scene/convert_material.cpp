#include "scene/limits.h"
#include "scene/materials.h"
#include "scene/names.h"

#include <algorithm>

#include <fmt/format.h>

namespace vkpt {

namespace {

// What the framework gives to a material that does not say.
constexpr double kDefaultAlbedo = 0.8;
constexpr double kDefaultIor = 1.5;
constexpr int kDefaultIllum = 2;
// No exponent is known to be the framework's: the widest lobe, with a warning.
constexpr double kDefaultExponent = 0.0;

constexpr double kLargestExponent = 1e6;
// Per unit of length: nothing is left after a millionth of that, and products with lengths stay finite.
constexpr double kLargestAbsorption = 1e6;

std::string colourText(const Vec3d& c) {
  return fmt::format("{} {} {}", shortNumber(c.x), shortNumber(c.y), shortNumber(c.z));
}

class Converter {
public:
  Converter(const MtlMaterial& mtl, TextureTable& textures, SceneReport& report)
      : m_mtl(mtl), m_textures(textures), m_report(report) {}

  Material run() {
    m_out.name = m_mtl.name;
    m_out.where = m_mtl.where;
    m_out.emission = Vec3f(emission());
    chooseShader();
    return std::move(m_out);
  }

private:
  void warn(std::size_t line, const std::string& what) {
    const SourceLocation where{m_mtl.where.file, line == 0 ? m_mtl.where.line : line};
    m_report.warnings.push_back(fmt::format("{}: material '{}': {}", where.text(), shown(m_mtl.name), what));
  }

  [[nodiscard]] Vec3d albedo() const { return m_mtl.kd.value_or(Vec3d(kDefaultAlbedo)); }

  Vec3d emission() {
    const Vec3d ka = m_mtl.ka.value_or(Vec3d(0.0));
    const Vec3d kd = albedo();
    if (m_mtl.ke && maxComponent(*m_mtl.ke) > 0.0) {
      return *m_mtl.ke;
    }
    const bool emits = maxComponent(ka) > 1.0 || maxComponent(kd) == 0.0;
    if (!emits || maxComponent(ka) == 0.0) {
      return Vec3d(0.0);
    }
    m_report.notes.push_back(fmt::format("{}: material '{}' emits its Ka, {}",
                                         SourceLocation{m_mtl.where.file, m_mtl.kaLine}.text(),
                                         shown(m_mtl.name), colourText(ka)));
    return ka;
  }

  void chooseShader() {
    const int illum = m_mtl.illum.value_or(kDefaultIllum);
    const IllumModel* model = findIllumModel(illum);
    if (model == nullptr) {
      warn(m_mtl.illumLine, fmt::format("illum {} is unknown; taken as diffuse", illum));
      makeDiffuse();
      return;
    }
    switch (model->shader) {
    case MtlShader::Phong:
      if (maxComponent(m_mtl.ks.value_or(Vec3d(0.0))) > 0.0) {
        makePhong(*m_mtl.ks);
      } else {
        makeDiffuse();
      }
      break;
    case MtlShader::Diffuse:
      makeDiffuse();
      break;
    case MtlShader::Mirror:
      m_out.bsdf = BsdfType::Mirror;
      m_out.reflectance = Vec3f(1.0F);
      break;
    case MtlShader::Absorbing:
      makeDielectric();
      absorb();
      break;
    case MtlShader::Dielectric:
      makeDielectric();
      break;
    case MtlShader::Metal:
      makeMetal();
      break;
    }
    const bool textured = m_out.bsdf == BsdfType::Diffuse || m_out.bsdf == BsdfType::Phong;
    if (m_mtl.mapKd && !textured) {
      warn(m_mtl.mapKd->where.line, fmt::format("illum {} has no texture; map_Kd is not used", illum));
    }
  }

  void makeDiffuse() {
    m_out.bsdf = BsdfType::Diffuse;
    const Vec3d most = colour();
    if (maxComponent(most) > 1.0) {
      warn(0, fmt::format("{} {} is above 1: it reflects more light than it gets; kept", kdName(),
                          colourText(most)));
    }
  }

  void makePhong(const Vec3d& ks) {
    const double ns = m_mtl.ns.value_or(kDefaultExponent);
    if (!(ns >= 0.0 && ns <= kLargestExponent)) {
      throw SceneError({m_mtl.where.file, m_mtl.nsLine},
                       fmt::format("material '{}': Ns {} is no exponent; give 0 to {:g}", shown(m_mtl.name),
                                   ns, kLargestExponent));
    }
    if (!m_mtl.ns) {
      warn(0,
           fmt::format("a Phong lobe (Ks above 0) without Ns; its exponent is taken as {}", shortNumber(ns)));
    }
    m_out.bsdf = BsdfType::Phong;
    m_out.specular = Vec3f(ks);
    m_out.exponent = static_cast<float>(ns);
    const Vec3d most = colour();
    if (maxComponent(most + ks) > 1.0 + kSumRounding) {
      warn(0, fmt::format("{} {} and Ks {} add up to more than 1: it gains energy; kept", kdName(),
                          colourText(most), colourText(ks)));
    }
  }

  [[nodiscard]] std::string_view kdName() const {
    return m_out.texture == kNoTexture ? "Kd" : "Kd times map_Kd";
  }

  /// Sets what Kd and map_Kd make together, and returns its largest value in each channel.
  Vec3d colour() {
    const Vec3d kd = albedo();
    m_out.reflectance = Vec3f(kd);
    TextureTable::Entry* image = m_mtl.mapKd ? m_textures.open(*m_mtl.mapKd) : nullptr;
    if (image == nullptr) {
      return kd;
    }
    const Vec3d most = kd * Vec3d(image->most);
    if (kd * Vec3d(image->least) == most) {
      m_out.reflectance = Vec3f(most);
    } else {
      m_out.texture = m_textures.use(*image);
    }
    return most;
  }

  void makeDielectric() {
    const double ni = m_mtl.ni.value_or(kDefaultIor);
    if (!(ni >= kLeastIor && ni <= kLargestIor)) {
      throw SceneError(
          {m_mtl.where.file, m_mtl.niLine},
          fmt::format("material '{}': Ni {} is no index of refraction; give {:g} to {:g}, glass has 1.5",
                      shown(m_mtl.name), shortNumber(ni), kLeastIor, kLargestIor));
    }
    m_out.bsdf = BsdfType::Dielectric;
    m_out.reflectance = Vec3f(1.0F);
    m_out.intIor = static_cast<float>(ni);
    m_out.extIor = 1.0F;
  }

  /// What is left after the distance d is exp(-(1 / Kd - 1) d).
  void absorb() {
    const Vec3d kd = albedo();
    if (maxComponent(kd) > 1.0) {
      warn(0, fmt::format("Kd {} of glass that absorbs is above 1; taken as 1, which absorbs nothing",
                          colourText(kd)));
    }
    if (1.0 / std::min({kd.x, kd.y, kd.z}) - 1.0 > kLargestAbsorption) {
      warn(0, fmt::format(
                  "Kd {} of glass that absorbs lets no light pass where it is 0; taken as an absorption of "
                  "{:g} per unit of length",
                  colourText(kd), kLargestAbsorption));
    }
    for (int c = 0; c < 3; ++c) {
      m_out.absorption[c] = static_cast<float>(std::clamp(1.0 / kd[c] - 1.0, 0.0, kLargestAbsorption));
    }
  }

  void makeMetal() {
    if (const Metal* metal = findMetal(m_mtl.name)) {
      m_out.bsdf = BsdfType::Conductor;
      m_out.reflectance = Vec3f(1.0F);
      m_out.eta = metal->eta;
      m_out.k = metal->k;
      return;
    }
    const Vec3d ks = m_mtl.ks.value_or(Vec3d(1.0));
    std::string known;
    for (const Metal& metal : kMetals) {
      known.append(known.empty() ? "" : ", ").append(metal.name);
    }
    warn(m_mtl.illumLine, fmt::format("no metal has this name (known: {}); taken as a mirror of Ks {}", known,
                                      colourText(ks)));
    m_out.bsdf = BsdfType::Mirror;
    m_out.reflectance = Vec3f(ks);
  }

  const MtlMaterial& m_mtl;
  TextureTable& m_textures;
  SceneReport& m_report;
  Material m_out;
};

} // namespace

Material convertMaterial(const MtlMaterial& mtl, TextureTable& textures, SceneReport& report) {
  return Converter(mtl, textures, report).run();
}

} // namespace vkpt
