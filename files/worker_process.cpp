#include "files/worker_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "files/byte_message.h"
#include "files/error.h"
#include "files/file_descriptor.h"
#include "files/message_socket.h"

extern char** environ;

namespace prairie {
namespace {

// A sanitizer claims terabytes of addresses for itself, and has something to say.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
constexpr bool kIsSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kIsSanitized = false;
#endif

/// What this process has of the memory that RLIMIT_DATA counts.
std::uint64_t own_data_bytes() {
  std::ifstream statm("/proc/self/statm");  // size resident shared text lib data dt, in pages
  std::uint64_t pages = 0;
  for (int field = 0; field < 6; ++field) statm >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void set_limit(decltype(RLIMIT_DATA) resource, std::uint64_t most) {
  const rlimit limit{.rlim_cur = most, .rlim_max = most};
  setrlimit(resource, &limit);
}

void die_with_parent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
}

int status_after(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string as_ending(int status) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return fmt::format("ends its decoder ({})", strsignal(number));
  }
  return "ends its decoder";
}

/// Whatever libraries print about a request is not for the person at the terminal.
void fall_silent() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

[[noreturn]] void do_request(MessageSocket& socket, const Work& work, const Message& request) {
  MessageReader reader(request.bytes);
  const auto memory_bytes = reader.number<std::uint64_t>();
  set_limit(RLIMIT_CORE, 0);
  if (!kIsSanitized) fall_silent();
  if (!kIsSanitized) set_limit(RLIMIT_DATA, own_data_bytes() + memory_bytes);
  work(reader.rest(), [&](std::span<const std::byte> bytes) { socket.send(MessageKind::kReply, bytes); });
  // Not `exit`: what the parent has registered for its own end is not this one's to do.
  _exit(0);
}

/// Waits for the end of a worker, and ends it where nobody is left who waits for its replies.
int status_of_followed(pid_t worker, const MessageSocket& socket) {
  const FileDescriptor watched(static_cast<int>(syscall(SYS_pidfd_open, worker, 0)));
  std::array<pollfd, 2> awaited{pollfd{.fd = watched.get(), .events = POLLIN, .revents = 0},
                                pollfd{.fd = socket.descriptor(), .events = 0, .revents = 0}};
  while (watched.is_open() && poll(awaited.data(), awaited.size(), -1) < 0 && errno == EINTR) {
  }
  if (awaited[1].revents != 0) kill(worker, SIGKILL);
  return status_after(worker);
}

/// Waits for requests and does each in a process of its own.
void serve(MessageSocket socket, const Work& work) {
  const pid_t self = getpid();
  while (const std::optional<Message> request = socket.receive()) {
    const pid_t worker = fork();
    if (worker == 0) {
      die_with_parent(self);
      do_request(socket, work, *request);
    }
    const auto id = static_cast<std::int32_t>(worker);
    socket.send(MessageKind::kBegun, MessageWriter().put(id).bytes());
    const int status = worker < 0 ? W_EXITCODE(1, 0) : status_of_followed(worker, socket);
    socket.send(MessageKind::kEnded, MessageWriter().put(static_cast<std::int32_t>(status)).bytes());
  }
}

std::optional<double> cpu_time_s(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return std::nullopt;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How long a worker has kept one waiting.
class Patience {
 public:
  explicit Patience(const WorkLimits& limits) : limits_(limits) {}

  void begins(pid_t worker) { worker_ = worker; }
  void replied(std::size_t bytes) {
    constexpr double kMB = 1e6;
    replied_MB_ += static_cast<double>(bytes) / kMB;
    waited_ = std::chrono::milliseconds(0);
    has_replied_ = true;
  }
  /// True when it is at an end.
  bool is_over(std::chrono::milliseconds waited) {
    waited_ += waited;
    const double cpu_s = worker_ > 0 ? cpu_time_s(worker_).value_or(0.0) : 0.0;
    if (std::exchange(has_replied_, false)) cpu_at_reply_s_ = cpu_s;
    return std::chrono::duration<double>(waited_).count() > limits_.waiting_s ||
           cpu_s - cpu_at_reply_s_ > limits_.cpu_s ||
           cpu_s > limits_.cpu_s + limits_.cpu_s_per_MB * replied_MB_;
  }

 private:
  const WorkLimits& limits_;
  pid_t worker_ = 0;
  double replied_MB_ = 0.0;
  double cpu_at_reply_s_ = 0.0;
  std::chrono::milliseconds waited_{0};
  bool has_replied_ = false;
};

}  // namespace

struct WorkerProcess::Conversation {
  Conversation(int descriptor, pid_t in_server) : socket(descriptor), server(in_server) {}

  MessageSocket socket;
  pid_t server;
  std::mutex mutex;

  /// Follows one request to its end; returns how the worker ended, or none where its server has ended.
  std::optional<int> follow(const WorkLimits& limits, const MessageSink& on_reply);
};

std::optional<int> WorkerProcess::Conversation::follow(const WorkLimits& limits,
                                                       const MessageSink& on_reply) {
  constexpr std::chrono::milliseconds kGlance{50};
  Patience patience(limits);
  pid_t worker = 0;
  std::exception_ptr refused;  // by `on_reply`
  bool is_ended_by_us = false;
  const auto end_worker = [&] {
    if (worker > 0 && !std::exchange(is_ended_by_us, true)) kill(worker, SIGKILL);
  };
  bool is_too_slow = false;
  while (true) {
    if (!socket.wait(kGlance)) {
      is_too_slow = is_too_slow || patience.is_over(kGlance);
      if (is_too_slow) end_worker();
      continue;
    }
    const std::optional<Message> message = socket.receive();
    if (!message) return std::nullopt;
    if (message->kind == MessageKind::kBegun) {
      worker = MessageReader(message->bytes).number<std::int32_t>();
      patience.begins(worker);
    } else if (message->kind == MessageKind::kEnded) {
      if (refused) std::rethrow_exception(refused);
      if (is_too_slow) throw WorkFailed("takes its decoder too long");
      return MessageReader(message->bytes).number<std::int32_t>();
    } else if (!refused) {
      patience.replied(message->bytes.size());
      try {
        on_reply(message->bytes);
      } catch (...) {
        refused = std::current_exception();
        end_worker();
      }
    }
  }
}

WorkerProcess::WorkerProcess(Work work) {
  const auto [near, far] = MessageSocket::pair();
  const pid_t server = fork();
  if (server == 0) {
    ::close(near);
    serve(MessageSocket(far), work);
    _exit(0);
  }
  ::close(far);
  conversation_ = std::make_unique<Conversation>(near, server);
}

WorkerProcess::WorkerProcess(const std::filesystem::path& program, const std::string& argument) {
  const auto [near, far] = MessageSocket::pair();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, far, STDIN_FILENO);
  std::string name = program.string();
  std::string argument_text = argument;
  std::array<char*, 3> arguments{name.data(), argument_text.data(), nullptr};
  pid_t server = -1;
  const int error = posix_spawn(&server, name.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(far);
  conversation_ = std::make_unique<Conversation>(near, server);
  if (error != 0) {
    conversation_->server = 0;
    throw BadInput(name, "", std::strerror(error), "the program that decodes");
  }
}

WorkerProcess::~WorkerProcess() {
  if (conversation_ == nullptr) return;
  conversation_->socket.close();
  if (conversation_->server > 0) status_after(conversation_->server);
}

void WorkerProcess::run(std::span<const std::byte> request, const WorkLimits& limits,
                        const MessageSink& on_reply) {
  const std::lock_guard lock(conversation_->mutex);
  MessageWriter message;
  message.put(limits.memory_bytes).append(request);
  std::optional<int> status;
  if (conversation_->server > 0 && conversation_->socket.send(MessageKind::kRequest, message.bytes()))
    status = conversation_->follow(limits, on_reply);
  if (!status) throw WorkFailed("cannot be decoded: the process that does it has ended");
  if (*status != 0) throw WorkFailed(as_ending(*status));
}

void serve_requests(const Work& work) {
  serve(MessageSocket(STDIN_FILENO), work);
}

}  // namespace prairie
