#include "scene/nori_tests.h"

#include "scene/names.h"
#include "scene/nori_bsdf.h"
#include "scene/nori_object.h"
#include "scene/nori_scene.h"
#include "scene/nori_values.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace vkpt {

namespace {

constexpr std::array<std::string_view, 2> kTTestTags{"bsdf", "scene"};
constexpr std::array<std::string_view, 1> kHostTags{"scene"};
constexpr std::array<std::string_view, 2> kTestTypes{"ttest", "chi2test"};
constexpr NoriRule kLevel{"more than 0 and less than 1", [](double x) { return x > 0.0 && x < 1.0; }};
constexpr NoriRule kCells{"1 to 1000", [](double x) { return x >= 1.0 && x <= 1000.0; }};
constexpr NoriRule kTwoOrMore{"2 or more", [](double x) { return x >= 2.0; }};
constexpr NoriRule kCountOrDefault{"1 or more, or -1 for 5000 a cell",
                                   [](double x) { return x >= 1.0 || x == -1.0; }};

class TestReader {
public:
  TestReader(const SceneText& source, SceneReport& report)
      : m_source(source), m_report(report), m_files(source, report) {}

  void read(const XmlElement& test) {
    if (noriTypeIndex(test, kTestTypes) == 0) {
      m_tests.tTests.push_back(readTTest(test));
    } else {
      m_tests.chi2Tests.push_back(readChi2Test(test));
    }
  }

  NoriTests take() { return std::move(m_tests); }

private:
  std::vector<Material> readBsdfs(const NoriObject& object) {
    std::vector<Material> bsdfs;
    for (const XmlElement* bsdf : object.children(kBsdfTags)) {
      bsdfs.push_back(readNoriBsdf(*bsdf, m_report));
    }
    return bsdfs;
  }

  static std::vector<double> readList(NoriObject& object, std::string_view name) {
    return noriNumbers(object.text(name).value_or(""), object.where(name), name);
  }

  NoriTTest readTTest(const XmlElement& element) {
    NoriObject object(element, kTTestTags, m_report);
    NoriTTest test;
    test.where = element.where;
    test.significanceLevel = object.number("significanceLevel", kLevel, test.significanceLevel);
    test.sampleCount = object.integer("sampleCount", kTwoOrMore, test.sampleCount);
    test.references = readList(object, "references");
    test.angles = readList(object, "angles");
    test.bsdfs = readBsdfs(object);
    const auto scenes = object.children(kHostTags);
    checkCounts(object, test, scenes.size());
    for (const XmlElement* scene : scenes) {
      test.scenes.push_back(readNoriScene(*scene, m_source, m_files, m_report));
    }
    object.warnOfUnread();
    return test;
  }

  static void checkCounts(const NoriObject& object, const NoriTTest& test, std::size_t sceneCount) {
    if (test.bsdfs.empty() == (sceneCount == 0)) {
      throw SceneError(object.where(), test.bsdfs.empty() ? "a test of nothing; give it a <bsdf> or a <scene>"
                                                          : "a test of bsdfs and scenes; make it two tests");
    }
    if (!test.bsdfs.empty() && test.angles.empty()) {
      throw SceneError(object.where(), "a test of bsdfs without angles; give those of incidence, in degrees");
    }
    const std::size_t due = test.bsdfs.empty() ? sceneCount : test.bsdfs.size() * test.angles.size();
    if (test.references.size() != due) {
      throw SceneError(object.where("references"),
                       fmt::format("references: {} numbers; give {}, one for each {}", test.references.size(),
                                   due, test.bsdfs.empty() ? "scene" : "angle of each bsdf"));
    }
  }

  NoriChi2Test readChi2Test(const XmlElement& element) {
    NoriObject object(element, kBsdfTags, m_report);
    NoriChi2Test test;
    test.where = element.where;
    test.significanceLevel = object.number("significanceLevel", kLevel, test.significanceLevel);
    test.resolution = object.integer("resolution", kCells, test.resolution);
    test.minExpFrequency = object.integer("minExpFrequency", kOneOrMore, test.minExpFrequency);
    const int count = object.integer("sampleCount", kCountOrDefault, -1);
    constexpr int kSamplesPerCell = 5000;
    const int cells = test.resolution * 2 * test.resolution;
    constexpr int kMostCells = std::numeric_limits<int>::max() / kSamplesPerCell;
    test.sampleCount = count > 0 ? count : kSamplesPerCell * std::min(cells, kMostCells);
    test.testCount = object.integer("testCount", kOneOrMore, test.testCount);
    test.bsdfs = readBsdfs(object);
    if (test.bsdfs.empty()) {
      throw SceneError(element.where, "a test of nothing; give it a <bsdf>");
    }
    object.warnOfUnread();
    return test;
  }

  const SceneText& m_source;
  SceneReport& m_report;
  NoriMeshFiles m_files;
  NoriTests m_tests;
};

} // namespace

NoriTests loadNoriTests(const fs::path& file, SceneReport& report) {
  if (!isNoriFile(file)) {
    throw SceneError({file.string()}, "is no file of tests; give a Nori .xml file");
  }
  const SceneText source = openScene(file, report.notes).front();
  const XmlElement root = parseXml(source);
  TestReader reader(source, report);
  if (root.tag == "test") {
    reader.read(root);
    return reader.take();
  }
  std::size_t count = 0;
  for (const XmlElement& child : root.children) {
    if (child.tag == "test") {
      reader.read(child);
      ++count;
    } else {
      report.warnings.push_back(fmt::format("{}: <{}> beside tests is ignored; move it into one",
                                            child.where.text(), shown(child.tag)));
    }
  }
  if (count == 0) {
    throw SceneError(root.where, fmt::format("no <test> in the file; vkpt {} renders a scene", source.name));
  }
  return reader.take();
}

} // namespace vkpt
