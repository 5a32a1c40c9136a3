#include "scene/nori_scene.h"

#include "scene/names.h"
#include "scene/nori_camera.h"
#include "scene/nori_integrator.h"
#include "scene/nori_light.h"
#include "scene/nori_object.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace vkpt {

namespace {

constexpr std::array<std::string_view, 7> kSceneTags{"mesh",    "emitter",    "luminaire", "camera",
                                                     "sampler", "integrator", "evaluator"};
constexpr std::array<std::string_view, 1> kMeshTags{"mesh"};
constexpr std::array<std::string_view, 1> kCameraTags{"camera"};
constexpr std::array<std::string_view, 1> kSamplerTags{"sampler"};
constexpr std::array<std::string_view, 1> kIntegratorTags{"integrator"};

/// The element, or one in it, that makes a file one of tests.
const XmlElement* findTest(const XmlElement& root) {
  if (root.tag == "test") {
    return &root;
  }
  const auto found = std::ranges::find(root.children, "test", &XmlElement::tag);
  return found == root.children.end() ? nullptr : &*found;
}

void note(SceneReport& report, const Scene& scene) {
  std::string text = fmt::format("Nori conventions: one-sided surfaces, normals as the file has them, "
                                 "horizontal fov, filter {}",
                                 noriFilterName(scene.filter.shape));
  if (std::ranges::find(report.notes, text) == report.notes.end()) {
    report.notes.push_back(std::move(text));
  }
}

} // namespace

bool isNoriFile(const fs::path& file) { return lowerCase(file.extension().string()) == ".xml"; }

Scene loadNoriScene(const SceneText& source, SceneReport& report) {
  const XmlElement root = parseXml(source);
  if (const XmlElement* test = findTest(root)) {
    throw SceneError(test->where, fmt::format("the file holds tests, no picture; vkpt selftest {} runs them",
                                              source.name));
  }
  if (root.tag != "scene") {
    throw SceneError(root.where,
                     fmt::format("unknown root element <{}>; a Nori scene is a <scene>", shown(root.tag)));
  }
  NoriMeshFiles files(source, report);
  return readNoriScene(root, source, files, report);
}

Scene readNoriScene(const XmlElement& element, const SceneText& source, NoriMeshFiles& files,
                    SceneReport& report) {
  const NoriObject object(element, kSceneTags, report);
  const XmlElement* camera = object.onlyChild(kCameraTags);
  const XmlElement* integrator = object.onlyChild(kIntegratorTags);
  const XmlElement* sampler = object.onlyChild(kSamplerTags);
  const std::vector<const XmlElement*> meshes = object.children(kMeshTags);
  if (camera == nullptr) {
    throw SceneError(element.where, "a scene without a camera; give <camera type=\"perspective\">");
  }
  if (meshes.empty()) {
    throw SceneError(element.where, "a scene without a mesh; give at least one <mesh type=\"obj\">");
  }
  Scene scene;
  scene.name = fs::path(source.fileName).stem().string();
  if (integrator != nullptr) {
    scene.defaults = readNoriIntegrator(*integrator, report);
  }
  if (sampler != nullptr) {
    scene.defaultFrames = readNoriSampler(*sampler, report);
  }
  readNoriCamera(*camera, scene, report);
  NoriGeometry geometry(files, report);
  for (const XmlElement* mesh : meshes) {
    geometry.add(*mesh, scene);
  }
  geometry.finish(scene);
  for (const XmlElement* light : object.children(kNoriLightTags)) {
    addNoriLight(*light, source, scene, report);
  }
  object.warnOfUnread();
  note(report, scene);
  return scene;
}

} // namespace vkpt
