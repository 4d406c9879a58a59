// An output that is too large to be encoded in memory first: written piece by piece under a temporary name in
// the same folder, flushed to the disk and renamed when it is whole. Given up halfway, it leaves nothing
// behind and what stood there before intact. "-" streams to stdout.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "app/terminal/interruption.h"

namespace prairie {

class StreamedOutput {
 public:
  /// Throws OutputFailure where the folder is missing or cannot be written.
  explicit StreamedOutput(std::filesystem::path path);
  ~StreamedOutput();
  StreamedOutput(const StreamedOutput&) = delete;
  StreamedOutput& operator=(const StreamedOutput&) = delete;

  void write(std::string_view bytes);
  /// Where the bytes are until `finish`; for another program that writes them in its place. Not of stdout.
  const std::filesystem::path& temporary_path() const { return temporary_->path(); }
  /// The last call: puts the output in place.
  void finish();

 private:
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path path_;
  std::optional<TemporaryFile> temporary_;  // none: stdout
  int descriptor_ = -1;
};

}  // namespace prairie
