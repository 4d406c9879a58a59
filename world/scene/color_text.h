// Colours as people write them.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace prairie {

/// "#rrggbb" in sRGB (IEC 61966-2-1) as linear RGB; nothing if the text is not of that form.
std::optional<glm::vec3> linear_from_hex(std::string_view text);

/// The text of that form that stands for exactly this colour, if there is one.
std::optional<std::string> hex_from_linear(const glm::vec3& linear);

}  // namespace prairie
