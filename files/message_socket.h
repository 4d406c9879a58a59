// Messages of any length through a pair of sockets, in packets that come whole or not at all: whoever ends in
// the middle of a message leaves nothing behind that could be taken for another one.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "files/file_descriptor.h"

namespace prairie {

enum class MessageKind : std::uint8_t { kRequest, kBegun, kReply, kEnded };

struct Message {
  MessageKind kind = MessageKind::kRequest;
  std::vector<std::byte> bytes;
};

class MessageSocket {
 public:
  explicit MessageSocket(int descriptor) : descriptor_(descriptor) {}

  /// Two that talk to each other. Throws OutputFailure where the system gives none.
  static std::pair<int, int> pair();

  int descriptor() const { return descriptor_.get(); }
  void close() { descriptor_.close(); }

  /// False where nobody listens any more.
  bool send(MessageKind kind, std::span<const std::byte> bytes);
  /// Waits for a message; none where nobody talks any more. What is left of a message whose sender has ended
  /// is dropped with the arrival of the next one.
  std::optional<Message> receive();
  /// True where a message, or the end of all, has come within that time.
  bool wait(std::chrono::milliseconds time) const;

 private:
  FileDescriptor descriptor_;
};

}  // namespace prairie
