#include "files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "files/error.h"

namespace prairie {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error, std::string expected) {
  throw OutputFailure(path.string(), "", std::strerror(error), std::move(expected));
}

/// A file under a name that nobody else uses, which vanishes unless it is renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) : target_(target) {
    // Unique between threads by the counter, between processes by the id, between machines that share a
    // folder by O_EXCL and the next number.
    static std::atomic<unsigned> counter{0};
    constexpr int kAttempts = 100;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      name_ = target;
      name_ += fmt::format(".{}.{}.tmp", ::getpid(), counter.fetch_add(1));
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ >= 0) return;
      if (errno != EEXIST && errno != EINTR) break;
    }
    fail(target_, errno, "a folder that can be written to");
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  void write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail(target_, written < 0 ? errno : EIO, "room for the whole file");
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }

  /// Flushes and closes; some file systems report a full disk only here.
  void finish() {
    if (::fsync(descriptor_) != 0) fail(target_, errno, "a disk that takes the whole file");
    const int descriptor = std::exchange(descriptor_, -1);
    if (::close(descriptor) != 0) fail(target_, errno, "a disk that takes the whole file");
  }

  void rename_to_target() {
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail(target_, errno, "a file that can be replaced");
    renamed_ = true;
  }

 private:
  std::filesystem::path target_;
  std::filesystem::path name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// Makes the rename itself survive a power cut. Some file systems cannot sync a folder; that is no failure.
void sync_folder(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  const int result = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  if (result != 0 && error == EIO) fail(path, error, "a disk that keeps the folder's entry");
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  TemporaryFile file(path);
  file.write(bytes);
  file.finish();
  file.rename_to_target();
  sync_folder(path);
}

void write_file_atomically(const std::filesystem::path& path, std::string_view text) {
  write_file_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace prairie
