// Numbers that come from outside must lie in a range.
#pragma once

#include <string>
#include <string_view>

namespace prairie {

/// Throws BadInput, which names the field, for a number that is not `low` to `high`, NaN among them. `what`:
/// put before the range that was expected.
void check_range(const std::string& field, double value, double low, double high, std::string_view what = {});

}  // namespace prairie
