#include "files/quiet_stderr.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <mutex>

namespace prairie {
namespace {

std::mutex mutex;
int depth = 0;      // objects alive, in any thread
int original = -1;  // a second descriptor of the stream meanwhile; −1 where it could not be made

}  // namespace

QuietStderr::QuietStderr() {
  const std::lock_guard lock(mutex);
  if (depth++ > 0) return;
  std::fflush(stderr);
  original = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (original >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  if (nowhere >= 0) ::close(nowhere);
}

QuietStderr::~QuietStderr() {
  const std::lock_guard lock(mutex);
  if (--depth > 0 || original < 0) return;
  std::fflush(stderr);
  ::dup2(original, STDERR_FILENO);
  ::close(original);
  original = -1;
}

}  // namespace prairie
