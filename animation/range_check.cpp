#include "animation/range_check.h"

#include <fmt/format.h>

#include "files/error.h"

namespace prairie {

void check_range(const std::string& field, double value, double low, double high, std::string_view what) {
  // Not so written as to let NaN pass.
  if (value >= low && value <= high) return;
  throw BadInput("", field, fmt::format("{}", value),
                 fmt::format("{}{}{} to {}", what, what.empty() ? "" : ", ", low, high));
}

}  // namespace prairie
