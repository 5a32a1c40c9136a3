#include "scene/nori_light.h"

#include "scene/limits.h"
#include "scene/names.h"
#include "scene/nori_object.h"
#include "scene/obj_reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace vkpt {

namespace {

constexpr NoriRule kRadiance{"0 to 1e12", [](double x) { return x >= 0.0 && x <= kLargestColour; }};

template<class T>
T required(const NoriObject& object, std::string_view name, const std::optional<T>& value,
           std::string_view example) {
  if (!value) {
    throw SceneError(object.where(), fmt::format("a light without {}; give {}", name, example));
  }
  return *value;
}

Vec3d requiredRadiance(NoriObject& object) {
  return required(object, "radiance", object.colour("radiance", kRadiance),
                  "<color name=\"radiance\" value=\"1,1,1\"/>");
}

void readPoint(NoriObject& object, const SceneText&, Scene& scene) {
  const auto position = object.vector("position");
  const auto power = object.colour("power", kRadiance);
  const auto intensity = object.colour("intensity", kRadiance);
  if (power.has_value() == intensity.has_value()) {
    throw SceneError(object.where(), "a point light needs its power (W) or its intensity (W/sr); give one");
  }
  const Vec3d world = required(object, "position", position, "<point name=\"position\" value=\"0,0,0\"/>");
  if (!(std::max({std::abs(world.x), std::abs(world.y), std::abs(world.z)}) <= kLargestCoordinate)) {
    throw SceneError(object.where("position"),
                     fmt::format("position is beyond {:g}; give smaller numbers", kLargestCoordinate));
  }
  scene.pointLights.push_back({object.where(), Vec3f(world - scene.origin),
                               Vec3f(intensity ? *intensity : *power / (4.0 * std::numbers::pi))});
}

void readDirectional(NoriObject& object, const SceneText&, Scene& scene) {
  const Vec3d direction = required(object, "direction", object.vector("direction"),
                                   "<vector name=\"direction\" value=\"0,-1,0\"/>");
  const Vec3d irradiance = required(object, "irradiance", object.colour("irradiance", kRadiance),
                                    "<color name=\"irradiance\" value=\"1,1,1\"/>");
  const double length = glm::length(direction);
  if (!(length > 0.0)) {
    throw SceneError(object.where("direction"), "direction has length 0; give the one the light travels in");
  }
  scene.directionalLights.push_back({object.where(), Vec3f(direction / length), Vec3f(irradiance)});
}

void refuseSecond(const NoriObject& object, bool isSecond) {
  if (isSecond) {
    throw SceneError(object.where(), "a second light of this type; a scene has one, keep one");
  }
}

void readEnvironment(NoriObject& object, const SceneText& source, Scene& scene) {
  refuseSecond(object, !scene.environment.file.empty());
  const std::string name =
      required(object, "filename", object.text("filename"), "<string name=\"filename\" value=\"sky.exr\"/>");
  const fs::path file = pathBeside(source, name);
  const std::string extension = lowerCase(file.extension().string());
  if (extension != ".hdr" && extension != ".exr") {
    throw SceneError(object.where("filename"),
                     fmt::format("'{}' is no environment map; give an .hdr or .exr file", shown(name)));
  }
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw SceneError(
        object.where("filename"),
        fmt::format("there is no file '{}'; names are relative to the scene's folder", shown(name)));
  }
  scene.environment.where = object.where();
  scene.environment.file = file;
}

void readConstant(NoriObject& object, const SceneText&, Scene& scene) {
  refuseSecond(object, scene.background != Vec3f(0.0F));
  scene.background = Vec3f(requiredRadiance(object));
}

struct NoriLight {
  std::string_view type;
  void (*read)(NoriObject&, const SceneText&, Scene&); ///< nullptr: stands in a mesh
};

constexpr std::array kLights{
    NoriLight{"area", nullptr},
    NoriLight{"point", readPoint},
    NoriLight{"directional", readDirectional},
    NoriLight{"environment", readEnvironment},
    NoriLight{"envmap", readEnvironment},
    NoriLight{"constant", readConstant},
};

} // namespace

Vec3f readNoriAreaLight(const XmlElement& light, SceneReport& report) {
  if (noriTypeEntry(light, kLights).read != nullptr) {
    throw SceneError(light.where, fmt::format("a light of type {} in a mesh; move it out, into <scene>",
                                              light.require("type")));
  }
  NoriObject object(light, {}, report);
  const Vec3f radiance(requiredRadiance(object));
  object.warnOfUnread();
  return radiance;
}

void addNoriLight(const XmlElement& light, const SceneText& source, Scene& scene, SceneReport& report) {
  const NoriLight& entry = noriTypeEntry(light, kLights);
  if (entry.read == nullptr) {
    throw SceneError(light.where, "an area light outside a mesh; move it into the <mesh> that shines");
  }
  NoriObject object(light, {}, report);
  entry.read(object, source, scene);
  object.warnOfUnread();
}

} // namespace vkpt
