#include "app/outputs/streamed_output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstring>
#include <utility>

#include "app/outputs/outputs.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr int kMaxAttempts = 100;

void flush_folder(const std::filesystem::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // the file itself is safe; some file systems refuse to open folders
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

StreamedOutput::StreamedOutput(std::filesystem::path path) : path_(std::move(path)) {
  if (path_ == kStandardOutput) {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  check_output_file(path_);
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    std::filesystem::path temporary = path_;
    temporary += fmt::format(".{}-{}.part", getpid(), attempt);
    temporary_.emplace(temporary);
    descriptor_ = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    // Left by a program of the same number that was killed, perhaps in another container.
    const bool taken = descriptor_ < 0 && errno == EEXIST;
    if (descriptor_ < 0 && !(taken && attempt < kMaxAttempts)) fail(errno);
  }
}

StreamedOutput::~StreamedOutput() {
  if (!temporary_ || descriptor_ < 0) return;
  close(descriptor_);
  unlink(temporary_->path().c_str());
}

void StreamedOutput::write(std::string_view bytes) {
  assert(descriptor_ >= 0);
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void StreamedOutput::finish() {
  if (!temporary_) return;
  if (fsync(descriptor_) != 0) fail(errno);
  // Closed before the rename, since network file systems report a full disk only then.
  if (close(std::exchange(descriptor_, -1)) != 0 || rename(temporary_->path().c_str(), path_.c_str()) != 0) {
    const int error_number = errno;
    unlink(temporary_->path().c_str());
    fail(error_number);
  }
  flush_folder(path_.has_parent_path() ? path_.parent_path() : ".");
}

void StreamedOutput::fail(int error_number) const {
  throw OutputFailure(temporary_ ? path_.string() : "standard output", "", std::strerror(error_number),
                      "room and permission to write");
}

}  // namespace prairie
