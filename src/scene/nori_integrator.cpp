#include "scene/nori_integrator.h"

#include "scene/nori_object.h"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vkpt {

namespace {

constexpr std::uint32_t bit(PathKind kind) { return 1U << static_cast<std::uint32_t>(kind); }

/// Reflections and refractions of what is seen, each surface lit directly; no light from surface to surface.
constexpr std::uint32_t kWhittedKinds =
    bit(PathKind::Emission) | bit(PathKind::Direct) | bit(PathKind::Specular);

struct NoriIntegrator {
  std::string_view type;
  EstimatorDefaults defaults;
};

constexpr std::array kIntegrators{
    NoriIntegrator{"path", {}},
    NoriIntegrator{"path_mats", {LightStrategy::Bsdf, {}, {}}},
    NoriIntegrator{"path_ems", {LightStrategy::Nee, {}, {}}},
    NoriIntegrator{"path_mis", {LightStrategy::Mis, {}, {}}},
    NoriIntegrator{"direct", {{}, 1, {}}},
    NoriIntegrator{"direct_mats", {LightStrategy::Bsdf, 1, {}}},
    NoriIntegrator{"direct_ems", {LightStrategy::Nee, 1, {}}},
    NoriIntegrator{"direct_mis", {LightStrategy::Mis, 1, {}}},
    NoriIntegrator{"light", {LightStrategy::Nee, 1, {}}},
    NoriIntegrator{"whitted", {LightStrategy::Nee, {}, kWhittedKinds}},
};

/// Pictures of something else than light, or of a light of their own.
constexpr std::array<std::string_view, 8> kNoTransport{"ao",          "av",    "depth",  "normals",
                                                       "directional", "naive", "simple", "photonmapper"};

constexpr std::array<std::string_view, 1> kSamplers{"independent"};

} // namespace

EstimatorDefaults readNoriIntegrator(const XmlElement& integrator, SceneReport& report) {
  const std::string& type = integrator.require("type");
  if (std::ranges::find(kNoTransport, type) != kNoTransport.end()) {
    std::vector<std::string_view> known;
    std::ranges::transform(kIntegrators, std::back_inserter(known), &NoriIntegrator::type);
    throw SceneError(integrator.where,
                     fmt::format("vkpt does not render '{}'; it renders light transport: {}", type,
                                 fmt::join(known, ", ")));
  }
  const NoriIntegrator& entry = noriTypeEntry(integrator, kIntegrators);
  const NoriObject object(integrator, {}, report);
  object.warnOfUnread();
  if (entry.defaults.pathKinds) {
    report.notes.push_back(fmt::format("{}: integrator {}: emission, direct and specular paths alone",
                                       integrator.where.text(), type));
  }
  return entry.defaults;
}

int readNoriSampler(const XmlElement& sampler, SceneReport& report) {
  static_cast<void>(noriTypeIndex(sampler, kSamplers));
  NoriObject object(sampler, {}, report);
  const int count = object.integer("sampleCount", kOneOrMore, 1);
  object.warnOfUnread();
  return count;
}

} // namespace vkpt
