#include "world/scene/color_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>

#include "pictures/srgb.h"

namespace prairie {
namespace {

/// Of 0…255.
std::optional<int> srgb_byte_from_linear(float linear) {
  for (int byte = 0; byte < 256; ++byte) {
    if (static_cast<float>(linear_from_srgb(byte / 255.0)) == linear) return byte;
  }
  return std::nullopt;
}

}  // namespace

std::optional<glm::vec3> linear_from_hex(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  glm::vec3 linear;
  for (int c = 0; c < 3; ++c) {
    const char* first = text.data() + 1 + 2 * c;
    unsigned value = 0;
    const auto result = std::from_chars(first, first + 2, value, 16);
    if (result.ec != std::errc() || result.ptr != first + 2) return std::nullopt;
    linear[c] = static_cast<float>(linear_from_srgb(value / 255.0));
  }
  return linear;
}

std::optional<std::string> hex_from_linear(const glm::vec3& linear) {
  const auto red = srgb_byte_from_linear(linear.x), green = srgb_byte_from_linear(linear.y),
             blue = srgb_byte_from_linear(linear.z);
  if (!red || !green || !blue) return std::nullopt;
  return fmt::format("#{:02x}{:02x}{:02x}", *red, *green, *blue);
}

}  // namespace prairie
