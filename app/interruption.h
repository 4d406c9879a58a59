// Ctrl-C at any moment leaves no half-written output: a thread waits for the signal, lets an atomic write
// that is under way finish, removes the temporary files of streamed outputs, and ends the program with 128 +
// the signal's number.
#pragma once

#include <filesystem>
#include <mutex>

namespace prairie {

/// Call once, before any other thread is started: all threads inherit the blocked signals.
void watch_for_interruption();

/// While it lives the program is not ended by a signal; for the short time in which an output is put in
/// place.
class UninterruptedWrite {
 public:
  UninterruptedWrite();

 private:
  std::unique_lock<std::mutex> lock_;
};

/// Registers a temporary file that an interruption must remove; forgets it at the end.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path path);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace prairie
