#include "app/terminal/interruption.h"

#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <thread>
#include <utility>
#include <vector>

#include "app/terminal/exit_code.h"

namespace prairie {
namespace {

// Shared by the writing threads and the one that waits for signals; never destroyed, since that thread never
// ends.
struct Unfinished {
  std::mutex mutex;
  std::vector<std::filesystem::path> temporary_files;
  std::vector<pid_t> processes;
};

Unfinished& unfinished() {
  static auto* const instance = new Unfinished;
  return *instance;
}

bool is_ignored(int signal_number) {
  struct sigaction action {};
  return sigaction(signal_number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

int status_after(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

[[noreturn]] void wait_and_end(sigset_t signals) {
  int signal_number = 0;
  while (sigwait(&signals, &signal_number) != 0) {
  }
  const std::unique_lock lock(unfinished().mutex);
  for (const pid_t process : unfinished().processes) kill(process, SIGKILL);
  // A killed process may be about to make a file until it has really gone.
  for (const pid_t process : unfinished().processes) status_after(process);
  for (const std::filesystem::path& path : unfinished().temporary_files) unlink(path.c_str());
  _exit(kExitSignalled + signal_number);
}

}  // namespace

void watch_for_interruption() {
  sigset_t signals;
  sigemptyset(&signals);
  // A signal that the caller has switched off (nohup, a script's background job) stays off.
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal_number)) sigaddset(&signals, signal_number);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread(wait_and_end, signals).detach();
}

UninterruptedWrite::UninterruptedWrite() : lock_(unfinished().mutex) {}

TemporaryFile::TemporaryFile(std::filesystem::path path) : path_(std::move(path)) {
  const std::unique_lock lock(unfinished().mutex);
  unfinished().temporary_files.push_back(path_);
}

TemporaryFile::~TemporaryFile() {
  const std::unique_lock lock(unfinished().mutex);
  std::erase(unfinished().temporary_files, path_);
}

StartedProcess::StartedProcess(pid_t id) : id_(id) {
  const std::unique_lock lock(unfinished().mutex);
  unfinished().processes.push_back(id_);
}

StartedProcess::~StartedProcess() {
  if (id_ == 0) return;
  kill(id_, SIGKILL);
  wait();
}

int StartedProcess::wait() {
  // Its number is free for others once it has been waited for, and must no longer be known here by then.
  siginfo_t ended{};
  while (waitid(P_PID, static_cast<id_t>(id_), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  const std::unique_lock lock(unfinished().mutex);
  std::erase(unfinished().processes, id_);
  return status_after(std::exchange(id_, 0));
}

}  // namespace prairie
