#include "app/outputs/outputs.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "app/terminal/interruption.h"
#include "files/atomic_file.h"
#include "files/error.h"

namespace prairie {
namespace fs = std::filesystem;
namespace {

void check_writable_folder(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status))
    throw OutputFailure(folder.string(), "", "no such folder", "a folder to write into");
  if (!fs::is_directory(status)) {
    throw OutputFailure(folder.string(), "", "no folder", "a folder to write into");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw OutputFailure(folder.string(), "", std::strerror(errno), "a folder to write into");
  }
}

}  // namespace

void check_output_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw OutputFailure(path.string(), "", fs::is_directory(status) ? "a folder" : "a device or pipe",
                        "a file's name");
  }
  check_writable_folder(path.has_parent_path() ? path.parent_path() : fs::path("."));
}

void make_output_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw OutputFailure(folder.string(), "", error.message(), "a folder to write into");
  check_writable_folder(folder);
}

void write_output(const fs::path& path, std::span<const std::byte> bytes) {
  const UninterruptedWrite uninterrupted;
  write_file_atomically(path, bytes);
}

void write_output(const fs::path& path, std::string_view text) {
  const UninterruptedWrite uninterrupted;
  write_file_atomically(path, text);
}

}  // namespace prairie
