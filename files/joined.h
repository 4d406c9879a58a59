// Texts in a row, as messages list them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace prairie {

/// "a, b, c", where ", " is `between`.
std::string joined(std::span<const std::string> texts, std::string_view between);

}  // namespace prairie
