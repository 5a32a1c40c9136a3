// A Nori file, read as a scene and as tests. The meshes it can name are quad.obj and smooth.obj.

#include "fuzz/input.h"
#include "fuzz/memory_bound.h"
#include "scene/load.h"
#include "scene/nori_tests.h"

#include <array>

namespace {

/// An element takes four bytes at the least (<a/>) and several hundred as a node of pugixml's and one of
/// ours.
constexpr std::size_t kBytesPerByte = 512;
constexpr std::size_t kBytesForNothing = std::size_t{1} << 20U; // chunks that files are read in

template<class Read>
void expectNoMoreThanAnError(const Read& read) {
  try {
    vkpt::SceneReport report;
    static_cast<void>(read(report));
  } catch (const vkpt::SceneError&) { // what a bad file is to give
  }
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  vkpt::test::writeFile("quad.obj", "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3 4\n");
  vkpt::test::writeFile("smooth.obj",
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nvn 0 1 1\nf 1/1/1 2/1/2 3/1/1\n");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vkpt;
  const std::string name = "fuzz.xml";
  test::writeFile(name, test::textOf(data, size));
  const std::array<fs::path, 1> files{name};
  const test::MemoryBound bound(kBytesForNothing + kBytesPerByte * size);
  expectNoMoreThanAnError([&](SceneReport& report) { return loadScene(files, report); });
  expectNoMoreThanAnError([&](SceneReport& report) { return loadNoriTests(name, report); });
  return 0;
}
