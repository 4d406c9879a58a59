#include "files/byte_message.h"

#include <cstring>

namespace prairie {

MessageWriter& MessageWriter::put(std::string_view text) {
  put(std::uint64_t{text.size()});
  const auto bytes = std::as_bytes(std::span(text));
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return *this;
}

MessageWriter& MessageWriter::put(const std::vector<std::string>& texts) {
  put(std::uint64_t{texts.size()});
  for (const std::string& text : texts) put(text);
  return *this;
}

MessageWriter& MessageWriter::put(std::span<const float> values) {
  put(std::uint64_t{values.size()});
  const auto bytes = std::as_bytes(values);
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return *this;
}

MessageWriter& MessageWriter::append(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return *this;
}

std::span<const std::byte> MessageReader::take(std::size_t count) {
  if (count > rest_.size()) throw BrokenMessage();
  const auto taken = rest_.first(count);
  rest_ = rest_.subspan(count);
  return taken;
}

std::size_t MessageReader::count(std::size_t bytes_each) {
  const auto told = number<std::uint64_t>();
  if (told > rest_.size() / bytes_each) throw BrokenMessage();
  return static_cast<std::size_t>(told);
}

std::string MessageReader::text() {
  const auto bytes = take(count(1));
  std::string text(bytes.size(), '\0');
  if (!bytes.empty()) std::memcpy(text.data(), bytes.data(), bytes.size());
  return text;
}

std::vector<std::string> MessageReader::texts() {
  std::vector<std::string> texts(count(sizeof(std::uint64_t)));
  for (std::string& each : texts) each = text();
  return texts;
}

std::optional<std::string> MessageReader::optional_text() {
  return has_value() ? std::optional(text()) : std::nullopt;
}

std::vector<float> MessageReader::floats() {
  std::vector<float> values(count(sizeof(float)));
  const auto bytes = take(values.size() * sizeof(float));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace prairie
