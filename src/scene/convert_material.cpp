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

// Squares of the index, and of its inverse, are to stay in the range of float.
constexpr double kLeastIor = 1e-6;
constexpr double kLargestIor = 1e6;

double largest(const Vec3d& colour) { return std::max({colour.x, colour.y, colour.z}); }

std::string colourText(const Vec3d& c) {
  return fmt::format("{} {} {}", shortNumber(c.x), shortNumber(c.y), shortNumber(c.z));
}

class Converter {
public:
  Converter(const MtlMaterial& mtl, SceneReport& report) : m_mtl(mtl), m_report(report) {}

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

  Vec3d emission() {
    const Vec3d ka = m_mtl.ka.value_or(Vec3d(0.0));
    const Vec3d kd = m_mtl.kd.value_or(Vec3d(kDefaultAlbedo));
    if (m_mtl.ke && largest(*m_mtl.ke) > 0.0) {
      return *m_mtl.ke;
    }
    const bool emits = largest(ka) > 1.0 || largest(kd) == 0.0;
    if (!emits || largest(ka) == 0.0) {
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
      if (largest(m_mtl.ks.value_or(Vec3d(0.0))) > 0.0) {
        warn(m_mtl.illumLine,
             fmt::format("illum {} with Ks above 0 has Phong highlights, which are not rendered; "
                         "taken as diffuse",
                         illum));
      }
      makeDiffuse();
      break;
    case MtlShader::Diffuse:
      makeDiffuse();
      break;
    case MtlShader::Mirror:
      m_out.bsdf = BsdfType::Mirror;
      m_out.reflectance = Vec3f(1.0F);
      break;
    case MtlShader::Absorbing:
      warn(m_mtl.illumLine,
           fmt::format("illum {} absorbs light, which is not rendered; taken as clear glass", illum));
      makeDielectric();
      break;
    case MtlShader::Dielectric:
      makeDielectric();
      break;
    case MtlShader::Metal:
      makeMetal();
      break;
    }
  }

  void makeDiffuse() {
    const Vec3d kd = m_mtl.kd.value_or(Vec3d(kDefaultAlbedo));
    if (largest(kd) > 1.0) {
      warn(0, fmt::format("Kd {} is above 1: it reflects more light than it gets; kept", colourText(kd)));
    }
    m_out.bsdf = BsdfType::Diffuse;
    m_out.reflectance = Vec3f(kd);
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
  SceneReport& m_report;
  Material m_out;
};

} // namespace

Material convertMaterial(const MtlMaterial& mtl, SceneReport& report) { return Converter(mtl, report).run(); }

} // namespace vkpt
