// Decimal numbers in text that other programs wrote, whatever the process's locale.
#pragma once

#include <optional>
#include <string_view>

namespace prairie {

/// The number that `text` consists of, blanks around it aside ("nan" and "inf" included); nothing if it is
/// none.
std::optional<double> parse_decimal(std::string_view text);

}  // namespace prairie
