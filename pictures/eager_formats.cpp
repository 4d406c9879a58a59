#include "pictures/eager_formats.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

namespace prairie {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kCodestream = "\xff\x4f\xff\x51"sv;  // ISO 15444-1 A.4.1: SOC, then SIZ
constexpr std::string_view kJpeg = "\xff\xd8\xff"sv;            // T.81 B.1.1.3: SOI, then a marker
constexpr std::string_view kBox = "\0\0\0\x0cjP  "sv;           // I.5.1
constexpr std::size_t kHeadBytes = 1 << 20;                     // profiles may stand before the codestream
constexpr std::size_t kSizBytes = 38;  // from its length up to the number of components

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

/// Four channels of 8 bits over the logical screen (GIF89a, 18).
std::uint64_t gif_bytes(std::string_view head) {
  const auto u16 = [head](std::size_t at) {
    return std::uint64_t{static_cast<unsigned char>(head[at])} |
           std::uint64_t{static_cast<unsigned char>(head[at + 1])} << 8;
  };
  return head.size() < 10 ? 0 : u16(6) * u16(8) * 4;
}

/// 32 bits per sample (ISO 15444-1 A.5.1).
std::uint64_t jpeg2000_bytes(std::string_view head) {
  const std::size_t start = head.find(kCodestream);
  if (start == std::string_view::npos || head.size() - start < kCodestream.size() + kSizBytes) return 0;
  const std::string_view siz = head.substr(start + kCodestream.size(), kSizBytes);
  const auto u32 = [siz](std::size_t at) { return big_endian(siz.substr(at, 4)); };
  // Extent of the reference grid less the offset of the image in it, and the number of components.
  const std::uint64_t width = u32(4) - std::min(u32(4), u32(12));
  const std::uint64_t height = u32(8) - std::min(u32(8), u32(16));
  const std::uint64_t components = big_endian(siz.substr(36, 2));
  constexpr std::uint64_t kMaxSide = std::uint64_t{1} << 24;  // keeps the product inside 64 bits
  return std::min(width, kMaxSide) * std::min(height, kMaxSide) * std::min<std::uint64_t>(components, 256) *
         4;
}

/// Coefficients of 16 bits for all samples where the frame is progressive (ITU-T T.81 B.2.2).
std::uint64_t jpeg_bytes(std::string_view head) {
  constexpr std::size_t kFrameBytes = 10;  // marker, length, precision, lines, samples per line, components
  std::size_t at = kJpeg.size() - 1;
  while (at + kFrameBytes <= head.size() && head[at] == '\xff') {
    const auto marker = static_cast<unsigned char>(head[at + 1]);
    const bool is_fill = marker == 0xff;
    const bool is_alone = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame) {
      const bool is_progressive = marker % 4 == 2;
      return is_progressive ? big_endian(head.substr(at + 5, 2)) * big_endian(head.substr(at + 7, 2)) *
                                  big_endian(head.substr(at + 9, 1)) * 2
                            : 0;
    }
    at += is_fill ? 1 : is_alone ? 2 : 2 + static_cast<std::size_t>(big_endian(head.substr(at + 2, 2)));
  }
  return 0;
}

}  // namespace

std::uint64_t eagerly_claimed_bytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string head(kBox.size(), '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  const bool is_gif = head.starts_with("GIF"), is_jpeg = head.starts_with(kJpeg);
  if (!stream || (!is_gif && !is_jpeg && !head.starts_with(kCodestream) && head != kBox)) return 0;
  head.resize(kHeadBytes);
  stream.read(head.data() + kBox.size(), static_cast<std::streamsize>(kHeadBytes - kBox.size()));
  head.resize(kBox.size() + static_cast<std::size_t>(stream.gcount()));
  return is_gif ? gif_bytes(head) : is_jpeg ? jpeg_bytes(head) : jpeg2000_bytes(head);
}

}  // namespace prairie
