// A write that fails leaves what was there, and nothing else.

#include "film/codecs.h"
#include "unit/film/film_fixtures.h"

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vkpt::test {
namespace {

/// No file of this process grows beyond `bytes` meanwhile: as if the disk were full.
class FullDisk {
public:
  explicit FullDisk(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &m_before);
    const rlimit limit{bytes, m_before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &m_before);
    std::signal(SIGXFSZ, m_handler);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

private:
  void (*m_handler)(int);
  rlimit m_before{};
};

std::string refusalOf(const fs::path& path) {
  const std::string said = messageOf<UsageError>([&] { checkOutputPath(path); });
  EXPECT_TRUE(said.starts_with(path.string() + ": ")) << said;
  EXPECT_EQ(messageOf<UsageError>([&] { writeImage(path, Image(2, 2, {"R", "G", "B"}), {}, {}); }), said);
  return said.substr(std::min(said.size(), path.string().size() + 2));
}

TEST(Writing, AFullDiskKeepsTheOldFile) {
  for (const std::string_view extension : kExtensions) {
    for (const rlim_t limit : {0UL, 1UL, 100UL, 700UL, 2000UL}) {
      const TemporaryFolder folder;
      const fs::path path = folder / std::string("x").append(extension);
      writeBytes(path, viewOf("the old file"));
      const Image image = noise(64, 64, {"R", "G", "B", "stderr.R"});
      std::string said;
      {
        const FullDisk full(limit);
        said = messageOf<Error>([&] { writeImage(path, image, {}, {}); });
      }
      EXPECT_EQ(said, path.string() + ": cannot be written: File too large");
      const film::Bytes left = film::readWholeFile(path);
      EXPECT_EQ(std::string(left.begin(), left.end()), "the old file") << extension;
      EXPECT_EQ(folder.names().size(), 1U) << extension;
    }
  }
}

/// EXR's table of offsets, written last and near the file's beginning, by a destructor that swallows errors.
TEST(Writing, EveryShortageIsSeen) {
  const TemporaryFolder folder;
  const Image image = noise(8, 40);
  for (const std::string_view extension : kExtensions) {
    const fs::path path = folder / std::string("x").append(extension);
    writeImage(path, image, {}, {});
    const auto size = static_cast<rlim_t>(fs::file_size(path));
    for (rlim_t limit = 0; limit < size; limit += 1 + size / 50) {
      const FullDisk full(limit);
      EXPECT_THROW(writeImage(path, image, {}, {}), Error) << extension << " " << limit << " of " << size;
    }
    const FullDisk full(size);
    EXPECT_NO_THROW(writeImage(path, image, {}, {})) << extension;
  }
  EXPECT_EQ(folder.names().size(), 4U);
}

TEST(Writing, ReplacesTheOldFileAndLeavesNothingElse) {
  const TemporaryFolder folder;
  for (const std::string_view extension : kExtensions) {
    const fs::path path = folder / std::string("x").append(extension);
    writeBytes(path, viewOf("the old file"));
    checkOutputPath(path);
    writeImage(path, noise(3, 2), {}, {});
    EXPECT_EQ(readImage(path).width, 3);
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"x.exr", "x.hdr", "x.pfm", "x.png"}));
  struct stat status {};
  ASSERT_EQ(::stat((folder / "x.png").c_str(), &status), 0);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  EXPECT_EQ(status.st_mode & 0777U, 0666U & ~mask); // as any other file's
}

TEST(Writing, WithoutACommitNothingChanges) {
  const TemporaryFolder folder;
  {
    film::AtomicFile file(folder / "x.png");
    file.write(viewOf("half of it"));
    EXPECT_EQ(folder.names().size(), 1U); // the temporary
    EXPECT_FALSE(fs::exists(folder / "x.png"));
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(Writing, ATargetThatBecomesAFolderIsKept) {
  const TemporaryFolder folder;
  {
    film::AtomicFile file(folder / "x.png");
    file.write(viewOf("all of it"));
    fs::create_directory(folder / "x.png");
    EXPECT_TRUE(messageOf<Error>([&] { file.commit(); }).ends_with("Is a directory"));
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"x.png"});
  EXPECT_TRUE(fs::is_directory(folder / "x.png"));
}

TEST(Writing, AFolderThatVanishesIsAnError) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "sub");
  film::AtomicFile file(folder.path() / "sub" / "x.png");
  fs::remove_all(folder / "sub");
  EXPECT_TRUE(messageOf<Error>([&] { file.commit(); }).ends_with("No such file or directory"));
}

TEST(Writing, SeeksAndOverwrites) {
  const TemporaryFolder folder;
  film::AtomicFile file(folder / "x");
  file.write(viewOf("0123456789"));
  file.seek(2);
  file.write(viewOf("ab"));
  EXPECT_EQ(file.position(), 4U);
  file.commit();
  const film::Bytes bytes = film::readWholeFile(folder / "x");
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "01ab456789");
}

TEST(OutputPath, RefusalsSayWhatWouldBeRight) {
  const TemporaryFolder folder;
  EXPECT_EQ(messageOf<UsageError>([&] { checkOutputPath("out.tiff"); }),
            "out.tiff: unknown image format; use .png, .exr, .hdr or .pfm");
  EXPECT_EQ(refusalOf(folder / "out"), "unknown image format; use .png, .exr, .hdr or .pfm");
  EXPECT_EQ(refusalOf(folder / ".png"), "unknown image format; use .png, .exr, .hdr or .pfm");
  const fs::path missing = folder / "missing";
  EXPECT_EQ(refusalOf(missing / "x.png"),
            "the folder " + missing.string() + " does not exist; create it or name another");
  writeBytes(folder / "file", {});
  EXPECT_EQ(refusalOf(folder / "file" / "x.exr"),
            (folder / "file").string() + " is not a folder; name a file in a folder");
  fs::create_directory(folder / "folder.png");
  EXPECT_EQ(refusalOf(folder / "folder.png"), "is a folder; name a file in it");
  ASSERT_EQ(::mkfifo((folder / "pipe.hdr").c_str(), 0600), 0);
  EXPECT_EQ(refusalOf(folder / "pipe.hdr"), "is no ordinary file; name another");
  EXPECT_EQ(refusalOf(folder / (std::string(300, 'x') + ".pfm")), "cannot be written: File name too long");
  EXPECT_TRUE(
      refusalOf("/proc/x.png").starts_with("cannot make a file in the folder /proc: ")); // for root too
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"file", "folder.png", "pipe.hdr"}));
}

TEST(OutputPath, TheLongestNameWorks) {
  const TemporaryFolder folder;
  const fs::path path = folder / (std::string(251, 'x') + ".pfm");
  checkOutputPath(path);
  EXPECT_TRUE(folder.names().empty());
  writeImage(path, noise(2, 2), {}, {});
  EXPECT_EQ(readImage(path).width, 2);
}

TEST(OutputPath, ANameWithoutAFolder) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  checkOutputPath("x.png");
  writeImage("x.png", noise(2, 2), {}, {});
  fs::current_path(before);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"x.png"});
}

TEST(Writing, SizesBeyondAFormatAreRefused) {
  const TemporaryFolder folder;
  EXPECT_NE(messageOf<UsageError>([&] { writeImage(folder / "x.png", Image{}, {}, {}); }).find("0x0"),
            std::string::npos);
  EXPECT_NO_THROW(film::checkPngSize(16384, 16384));
  EXPECT_NO_THROW(film::checkHdrSize(16384, 16384));
  EXPECT_NE(messageOf<UsageError>([] { film::checkPngSize(30000, 30000); }).find("30000x30000"),
            std::string::npos);
  EXPECT_THROW(film::checkPngSize(2147483647, 2147483647), UsageError);
  EXPECT_THROW(film::checkPngSize(1 << 25, 1), UsageError);
  EXPECT_THROW(film::checkHdrSize(30000, 30000), UsageError);
  EXPECT_THROW(film::checkHdrSize(2147483647, 2147483647), UsageError);
}

} // namespace
} // namespace vkpt::test
