// Work that may crash, hang or swell – decoding files that nobody vouches for – done in another process: each
// request by a new one, with limits, so that whatever it does to itself is the end of that request alone.
//
// It guards against faults of decoders, not against code that a file might smuggle into them: the worker may
// do what the user may do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace prairie {

/// Takes a message of any length.
using MessageSink = std::function<void(std::span<const std::byte>)>;

/// What a worker does with a request; `reply` may be called any number of times. Must not throw.
using Work = std::function<void(std::span<const std::byte> request, const MessageSink& reply)>;

struct WorkLimits {
  std::uint64_t memory_bytes = 0;  // that the worker may ask for, beyond what it starts with
  double cpu_s = 4.0;              // of processor time between two replies, and in all, where
  double cpu_s_per_MB = 0.5;       // so much is added for each megabyte (10⁶ bytes) that it has replied
  double waiting_s = 20.0;         // between two replies, for a disk or for ever
};

/// The worker did not come to an end by itself; `what()` says how it ended: "ends its decoder (signal 11)".
struct WorkFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Waits for requests and has each done. One at a time; thread-safe. Ends with this process, whichever way.
class WorkerProcess {
 public:
  /// A copy of this process. To be called before any other thread is started.
  explicit WorkerProcess(Work work);
  /// Runs `program` with `arguments`, which has to call `serve_requests`. Throws BadInput where that cannot
  /// be.
  WorkerProcess(const std::filesystem::path& program, const std::string& argument);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Hands the replies to `on_reply` in their order. Throws WorkFailed, and what `on_reply` throws; the
  /// worker is ended then.
  void run(std::span<const std::byte> request, const WorkLimits& limits, const MessageSink& on_reply);

 private:
  struct Conversation;
  std::unique_ptr<Conversation> conversation_;
};

/// The other side of a started program: does what is asked through its standard input until that is closed.
void serve_requests(const Work& work);

}  // namespace prairie
