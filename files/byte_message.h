// Values in a row of bytes and back, for what one process tells another of the same program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "files/little_endian.h"

namespace prairie {

class MessageWriter {
 public:
  template <FixedWidth Number>
  MessageWriter& put(Number number) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(Number));
    put_little_endian(std::span(bytes_).subspan(at), number);
    return *this;
  }
  MessageWriter& put(std::string_view text);
  MessageWriter& put(const std::vector<std::string>& texts);
  template <class Value>
  MessageWriter& put(const std::optional<Value>& value) {
    put(static_cast<std::uint8_t>(value.has_value()));
    if (value) put(*value);
    return *this;
  }
  MessageWriter& put(std::span<const float> values);

  /// Bytes as they are, to the end of the message.
  MessageWriter& append(std::span<const std::byte> bytes);

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

/// A message that is shorter than what is asked of it, as a process writes that goes wrong.
struct BrokenMessage : std::runtime_error {
  BrokenMessage() : std::runtime_error("a message that breaks off") {}
};

/// Takes values in the order in which they were put; throws BrokenMessage.
class MessageReader {
 public:
  explicit MessageReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <FixedWidth Number>
  Number number() {
    return little_endian<Number>(take(sizeof(Number)));
  }
  std::string text();
  std::vector<std::string> texts();
  template <FixedWidth Number>
  std::optional<Number> optional_number() {
    return has_value() ? std::optional(number<Number>()) : std::nullopt;
  }
  std::optional<std::string> optional_text();
  bool has_value() { return number<std::uint8_t>() != 0; }
  std::vector<float> floats();
  std::span<const std::byte> rest() const { return rest_; }

 private:
  std::span<const std::byte> take(std::size_t count);
  /// How many of at least `bytes_each` follow.
  std::size_t count(std::size_t bytes_each);

  std::span<const std::byte> rest_;
};

}  // namespace prairie
