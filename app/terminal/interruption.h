// Ctrl-C at any moment leaves no half-written output: a thread waits for the signal, lets an atomic write
// that is under way finish, ends the processes that write for this one, removes the temporary files of
// streamed outputs, and ends the program with 128 + the signal's number.
#pragma once

#include <sys/types.h>

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

/// Registers a process that this one has started, and that an interruption must end before it removes what
/// that process writes. Ended at the end of its scope, too.
class StartedProcess {
 public:
  explicit StartedProcess(pid_t id);
  ~StartedProcess();
  StartedProcess(const StartedProcess&) = delete;
  StartedProcess& operator=(const StartedProcess&) = delete;

  /// Waits for its end and returns its status as waitpid tells it.
  int wait();

 private:
  pid_t id_;  // 0: has ended
};

}  // namespace prairie
