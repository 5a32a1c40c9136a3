#pragma once
// What the tests of the film share.

#include "film/file_io.h"
#include "film/film.h"
#include "film/image.h"

#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt::test {

/// Seeded with the hash of the running test's name.
std::mt19937_64 randomOfTest();

/// A folder of its own, removed with all it holds.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] fs::path operator/(const std::string& name) const { return m_path / name; }
  [[nodiscard]] const fs::path& path() const { return m_path; }
  /// The names in it, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

private:
  fs::path m_path;
};

void writeBytes(const fs::path& path, film::ByteView bytes);
inline film::ByteView viewOf(std::string_view text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

inline constexpr std::string_view kExtensions[] = {".png", ".exr", ".hdr", ".pfm"};

/// R, G, B and more channels as named, uniform in [0, 1).
Image noise(int width, int height, std::initializer_list<const char*> names = {"R", "G", "B"});

/// Sum of squared deviations and mean, in two passes of long double.
struct Direct {
  long double mean = 0.0L;
  long double m2 = 0.0L;
};
Direct directMoments(const std::vector<double>& samples);

/// The message of the E that `call` throws; "" and a failure where it throws none.
template<class E, class F>
std::string messageOf(F&& call);

} // namespace vkpt::test

#include <gtest/gtest.h>

template<class E, class F>
std::string vkpt::test::messageOf(F&& call) {
  try {
    call();
  } catch (const E& e) {
    EXPECT_EQ(std::string_view(e.what()).find('\n'), std::string_view::npos) << e.what();
    return e.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}
