#include "world/color_text.h"

#include <charconv>
#include <cstddef>

#include "pictures/srgb.h"

namespace prairie {

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

}  // namespace prairie
