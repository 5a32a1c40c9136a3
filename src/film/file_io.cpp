#include "film/file_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace vkpt::film {

namespace {

std::string reasonOf(int error) { return std::generic_category().message(error); }

/// A file descriptor that closes itself.
class Descriptor {
public:
  explicit Descriptor(int file) : m_file(file) {}
  ~Descriptor() {
    if (m_file >= 0)
      ::close(m_file);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return m_file; }

private:
  int m_file;
};

fs::path folderOf(const fs::path& path) {
  const fs::path folder = path.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

void checkTarget(const fs::path& target) {
  std::error_code error;
  const fs::path folder = folderOf(target);
  if (!fs::exists(folder, error))
    throw UsageError(fmt::format("{}: the folder {} does not exist; create it or name another",
                                 target.string(), folder.string()));
  if (!fs::is_directory(folder, error))
    throw UsageError(
        fmt::format("{}: {} is not a folder; name a file in a folder", target.string(), folder.string()));
  const fs::file_status status = fs::status(target, error);
  if (status.type() == fs::file_type::directory)
    throw UsageError(fmt::format("{}: is a folder; name a file in it", target.string()));
  if (status.type() == fs::file_type::none)
    throw UsageError(fmt::format("{}: cannot be written: {}", target.string(), error.message()));
  if (fs::exists(status) && status.type() != fs::file_type::regular)
    throw UsageError(fmt::format("{}: is no ordinary file; name another", target.string()));
}

/// Makes a new file in `folder` and gives its descriptor, or -1 with errno. Its name is short and does not
/// depend on the target's, so a name of the full length allowed works too.
int makeTemporary(const fs::path& folder, fs::path& name) {
  static std::atomic<unsigned> serial{0};
  constexpr int kAttempts = 1000; // leftovers of a killed process that had our id
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    name = folder / fmt::format(".vkpt-{}-{}.tmp", ::getpid(), serial++);
    const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST)
      return file;
  }
  return -1;
}

} // namespace

Bytes readWholeFile(const fs::path& path) {
  const auto fail = [&](int reason) {
    throw SceneError({path.string()}, "cannot be read: " + reasonOf(reason));
  };
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0)
    fail(errno);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0)
    fail(errno);
  // A guess, since a pipe has no size; one byte more, to see the end without another turn.
  Bytes bytes(static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) + 1);
  std::size_t size = 0;
  for (;;) {
    if (size == bytes.size())
      bytes.resize(2 * size);
    const ssize_t got = ::read(file.get(), bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      fail(errno);
    if (got == 0)
      break;
    size += static_cast<std::size_t>(got);
  }
  bytes.resize(size);
  return bytes;
}

AtomicFile::AtomicFile(const fs::path& target) : m_target(target) {
  checkTarget(target);
  m_file = makeTemporary(folderOf(target), m_temporary);
  if (m_file < 0)
    throw UsageError(fmt::format("{}: cannot make a file in the folder {}: {}", target.string(),
                                 folderOf(target).string(), reasonOf(errno)));
}

AtomicFile::~AtomicFile() {
  if (m_file >= 0)
    ::close(m_file);
  if (!m_temporary.empty())
    ::unlink(m_temporary.c_str());
}

void AtomicFile::write(ByteView bytes) noexcept {
  while (m_error == 0 && !bytes.empty()) {
    const ssize_t put = ::pwrite(m_file, bytes.data(), bytes.size(), static_cast<off_t>(m_position));
    if (put > 0) {
      m_position += static_cast<std::uint64_t>(put);
      bytes = bytes.subspan(static_cast<std::size_t>(put));
    } else if (put == 0 || errno != EINTR) {
      m_error = put == 0 ? EIO : errno;
    }
  }
}

void AtomicFile::fail(int reason) const {
  throw Error(ExitCode::Usage, fmt::format("{}: cannot be written: {}", m_target.string(), reasonOf(reason)));
}

void AtomicFile::commit() {
  if (m_error != 0)
    fail(m_error);
  if (::fsync(m_file) != 0 && errno != EINVAL) // EINVAL: a file system without fsync
    fail(errno);
  if (::close(std::exchange(m_file, -1)) != 0)
    fail(errno);
  if (::rename(m_temporary.c_str(), m_target.c_str()) != 0)
    fail(errno);
  m_temporary.clear();
  // The new name itself; the data are safe already, and not every file system can sync a folder.
  const Descriptor folder(::open(folderOf(m_target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() >= 0)
    static_cast<void>(::fsync(folder.get()));
}

void writeTextFile(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  file.commit();
}

} // namespace vkpt::film
