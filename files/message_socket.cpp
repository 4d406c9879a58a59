#include "files/message_socket.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "files/error.h"

namespace prairie {
namespace {

constexpr std::size_t kPacketBytes = 60'000;  // fits into what a socket holds by default

struct PacketHead {
  MessageKind kind = MessageKind::kRequest;
  std::uint8_t is_first = 0;
  std::uint8_t is_last = 0;
};

bool send_packet(int descriptor, PacketHead head, std::span<const std::byte> part) {
  std::array<iovec, 2> parts{iovec{&head, sizeof head},
                             iovec{const_cast<std::byte*>(part.data()), part.size()}};
  msghdr packet{};
  packet.msg_iov = parts.data();
  packet.msg_iovlen = parts.size();
  while (true) {
    if (sendmsg(descriptor, &packet, MSG_NOSIGNAL) >= 0) return true;
    if (errno != EINTR) return false;
  }
}

}  // namespace

std::pair<int, int> MessageSocket::pair() {
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw OutputFailure("", "", std::strerror(errno), "a pair of sockets");
  return {ends[0], ends[1]};
}

bool MessageSocket::send(MessageKind kind, std::span<const std::byte> bytes) {
  PacketHead head{.kind = kind, .is_first = 1};
  do {
    const auto part = bytes.first(std::min(bytes.size(), kPacketBytes));
    bytes = bytes.subspan(part.size());
    head.is_last = bytes.empty() ? 1 : 0;
    if (!send_packet(descriptor_.get(), head, part)) return false;
    head.is_first = 0;
  } while (!bytes.empty());
  return true;
}

std::optional<Message> MessageSocket::receive() {
  Message message;
  std::array<std::byte, kPacketBytes> part;
  while (true) {
    PacketHead head;
    std::array<iovec, 2> parts{iovec{&head, sizeof head}, iovec{part.data(), part.size()}};
    msghdr packet{};
    packet.msg_iov = parts.data();
    packet.msg_iovlen = parts.size();
    const ssize_t count = recvmsg(descriptor_.get(), &packet, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count < static_cast<ssize_t>(sizeof head)) return std::nullopt;
    if (head.is_first != 0) message = {.kind = head.kind, .bytes = {}};
    message.bytes.insert(message.bytes.end(), part.begin(),
                         part.begin() + (count - static_cast<ssize_t>(sizeof head)));
    if (head.is_last != 0) return message;
  }
}

bool MessageSocket::wait(std::chrono::milliseconds time) const {
  pollfd awaited{.fd = descriptor_.get(), .events = POLLIN, .revents = 0};
  return poll(&awaited, 1, static_cast<int>(time.count())) > 0;
}

}  // namespace prairie
