#include "files/decimal.h"

#include <charconv>
#include <limits>

namespace prairie {

std::optional<double> parse_decimal(std::string_view text) {
  // GDAL ends its text with a zero byte, which some programs count as part of it.
  constexpr std::string_view kBlank(" \t\r\n\0", 5);
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(kBlank) - first + 1);
  // from_chars knows no leading plus.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ptr != text.data() + text.size()) return std::nullopt;
  if (result.ec == std::errc::result_out_of_range) {
    // Beyond double's range on either side; what is too small is no different from zero here.
    const bool tiny = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
    if (tiny) return 0.0;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return text[0] == '-' ? -kInfinity : kInfinity;
  }
  if (result.ec != std::errc()) return std::nullopt;
  return value;
}

}  // namespace prairie
