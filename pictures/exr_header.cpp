#include "pictures/exr_header.h"

#include <array>
#include <fstream>
#include <optional>

namespace prairie {
namespace {

constexpr std::uint32_t kMagic = 0x01312f76;
constexpr std::uint32_t kMultiPart = 0x1000;
constexpr int kMaxAttributes = 10'000;
constexpr int kMaxNameBytes = 256;  // with its end

std::optional<std::uint32_t> read_u32(std::istream& stream) {
  std::array<char, 4> bytes{};
  if (!stream.read(bytes.data(), bytes.size())) return std::nullopt;
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

/// Length of a text that ends with a zero byte, which is skipped; nothing if it is too long or the file ends.
std::optional<int> skip_text(std::istream& stream) {
  for (int length = 0; length < kMaxNameBytes; ++length) {
    const int byte = stream.get();
    if (byte == std::istream::traits_type::eof()) return std::nullopt;
    if (byte == 0) return length;
  }
  return std::nullopt;
}

}  // namespace

bool exr_header_fits(const std::filesystem::path& path, std::uint64_t file_bytes) {
  std::ifstream stream(path, std::ios::binary);
  if (read_u32(stream) != kMagic) return true;
  const std::optional<std::uint32_t> version = read_u32(stream);
  if (!version) return false;
  // Each part's header ends with an empty name; a list of parts ends with an empty header.
  bool header_is_empty = true;
  for (int attribute = 0; attribute < kMaxAttributes; ++attribute) {
    const std::optional<int> name = skip_text(stream);
    if (!name) return false;
    if (*name == 0) {
      if (header_is_empty || (*version & kMultiPart) == 0) return true;
      header_is_empty = true;
      continue;
    }
    header_is_empty = false;
    if (!skip_text(stream)) return false;
    const std::optional<std::uint32_t> size = read_u32(stream);
    if (!size || *size > file_bytes) return false;
    stream.seekg(*size, std::ios::cur);
    if (static_cast<std::uint64_t>(stream.tellg()) > file_bytes) return false;
  }
  return false;
}

}  // namespace prairie
