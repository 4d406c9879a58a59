// Colours as people write them.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

namespace prairie {

/// "#rrggbb" in sRGB (IEC 61966-2-1) as linear RGB; nothing if the text is not of that form.
std::optional<glm::vec3> linear_from_hex(std::string_view text);

}  // namespace prairie
