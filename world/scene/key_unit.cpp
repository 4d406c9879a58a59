#include "world/scene/key_unit.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "world/scene/bearing.h"

namespace prairie {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;
constexpr double kMPerMm = 1e-3;

/// But for rounding.
double nearly_key_from_member(Unit unit, double value) {
  switch (unit) {
    case Unit::kMembers:
      return value;
    case Unit::kMillimetres:
      return value / kMPerMm;
    case Unit::kDegrees:
      return value / kRadPerDeg;
    case Unit::kBearing:
      return 90.0 - value / kRadPerDeg;
  }
  return value;
}

}  // namespace

double member_from_key(Unit unit, double value) {
  switch (unit) {
    case Unit::kMembers:
      return value;
    case Unit::kMillimetres:
      return value * kMPerMm;
    case Unit::kDegrees:
      return value * kRadPerDeg;
    case Unit::kBearing:
      return heading_rad_of(value);
  }
  return value;
}

double key_from_member(Unit unit, double value, bool is_float) {
  const double nearly = nearly_key_from_member(unit, value);
  const auto gives_value = [&](double key) {
    const double member = member_from_key(unit, key);
    return is_float ? static_cast<float>(member) == static_cast<float>(value) : member == value;
  };
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    const std::string text = fmt::format("{:.{}g}", nearly, digits);
    double rounded = nearly;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    if (gives_value(rounded)) return rounded + 0.0;  // no negative zero
  }
  // The way there and back has rounded to one of its neighbours.
  constexpr int kNeighbours = 8;
  double below = nearly, above = nearly;
  for (int n = 0; n < kNeighbours; ++n) {
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
    if (gives_value(below)) return below;
    if (gives_value(above)) return above;
  }
  return nearly;
}

}  // namespace prairie
