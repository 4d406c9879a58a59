// Directions as people give them, clockwise from north in degrees, and as the mathematics has them, from
// east, counter-clockwise in radians.
#pragma once

#include <numbers>

namespace prairie {

inline double heading_rad_of(double bearing_deg) {
  return (90.0 - bearing_deg) * std::numbers::pi / 180.0;
}

}  // namespace prairie
