// An OBJ file with its MTL file: the input is the one, a line "#MTL", and the other, which `mtllib fuzz.mtl`
// names.

#include "fuzz/input.h"
#include "fuzz/memory_bound.h"
#include "scene/load.h"

#include <array>

namespace {

/// A face of three corners takes seven bytes at the least, and about 500 as a triangle with vertices of its
/// own, normals, a line number and a warning.
constexpr std::size_t kBytesPerByte = 256;
constexpr std::size_t kBytesForNothing = std::size_t{1} << 20U; // chunks that files are read in

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace vkpt;
  constexpr std::string_view kBetween = "\n#MTL\n";
  const std::string_view text = test::textOf(data, size);
  const std::size_t cut = text.find(kBetween);
  test::writeFile("fuzz.obj", text.substr(0, cut));
  test::writeFile("fuzz.mtl", cut == std::string_view::npos ? "" : text.substr(cut + kBetween.size()));
  const std::array<fs::path, 1> files{"fuzz.obj"};
  const test::MemoryBound bound(kBytesForNothing + kBytesPerByte * size);
  try {
    SceneReport report;
    static_cast<void>(loadScene(files, report));
  } catch (const SceneError&) { // what a bad file is to give
  }
  return 0;
}
