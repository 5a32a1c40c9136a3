#include "unit/film/film_fixtures.h"

#include "core/hash.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace vkpt::test {

std::mt19937_64 randomOfTest() {
  return std::mt19937_64(hashText(::testing::UnitTest::GetInstance()->current_test_info()->name()));
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "vkpt-film-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("no temporary folder");
  m_path = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(m_path, ignored);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(m_path))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

void writeBytes(const fs::path& path, film::ByteView bytes) {
  fs::remove(
      path); // a truncated file's new bytes go to the disk at once, on ext4: thousands of them take long
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  ASSERT_TRUE(out.flush());
}

Image noise(int width, int height, std::initializer_list<const char*> names) {
  auto random = randomOfTest();
  std::uniform_real_distribution<float> uniform;
  Image image(width, height, names);
  for (Image::Channel& channel : image.channels)
    for (float& v : channel.values)
      v = uniform(random);
  return image;
}

Direct directMoments(const std::vector<double>& samples) {
  Direct d;
  for (const double x : samples)
    d.mean += x;
  d.mean /= static_cast<long double>(samples.size());
  for (const double x : samples)
    d.m2 += (x - d.mean) * (x - d.mean);
  return d;
}

} // namespace vkpt::test
