#include "scenes/render_fixture.h"

#include "film/image.h"

#include <algorithm>

namespace vkpt::test {

const gpu::Context& sharedContext() {
  static const gpu::Context context({"", true});
  return context;
}

Rendered renderScene(const Scene& scene, const RenderSetup& setup) {
  return renderScene(sharedContext(), scene, setup);
}

std::string currentTestName() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return info == nullptr ? "none" : std::string(info->test_suite_name()) + "." + info->name();
}

std::string savePicture(const Film& film, const std::string& name) {
  std::string folderName = currentTestName();
  std::ranges::replace(folderName, '/', '-');
  const fs::path folder = fs::temp_directory_path() / "vkpt-tests" / folderName;
  fs::create_directories(folder);
  const fs::path stem = folder / name;
  for (const char* extension : {".exr", ".png"})
    writeImage(stem.string() + extension, develop(film), {}, {});
  return stem.string() + ".{exr,png}";
}

void RenderTest::SetUp() { m_messagesBefore = sharedContext().validationMessages(); }

void RenderTest::TearDown() {
  EXPECT_EQ(sharedContext().validationMessages(), m_messagesBefore)
      << "the validation layer spoke; see above";
  if (!HasFailure())
    return;
  for (std::size_t i = 0; i < m_pictures.size(); ++i)
    std::cout << "picture: " << savePicture(m_pictures[i], "render-" + std::to_string(i)) << '\n';
}

Rendered RenderTest::render(const Scene& scene, RenderSetup setup) {
  constexpr std::size_t kMostPictures = 8;
  if (setup.seed == 0)
    setup.seed = seed();
  Rendered r = renderScene(scene, setup);
  EXPECT_EQ(r.counters.faults(), 0U) << "nonFinite " << r.counters.nonFinite << ", cutTraversal "
                                     << r.counters.cutTraversal << ", stackOverflow "
                                     << r.counters.stackOverflow << ", invalidPdf " << r.counters.invalidPdf;
  if (m_pictures.size() < kMostPictures)
    m_pictures.push_back(r.film);
  return r;
}

} // namespace vkpt::test
