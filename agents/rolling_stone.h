// A stone that someone lets roll: straight ahead over the ground until its way ends, where it lies (G03 fig.
// 4).
#pragma once

#include <glm/vec2.hpp>

#include "agents/mover.h"
#include "maps/height_field.h"

namespace prairie {

struct RollingStone {
  double radius_m = 0.4;  // 0.05…3
  glm::dvec2 start_m{0.0};
  double heading_rad = 0.0;  // from east, counter-clockwise
  double speed_m_per_s = 2.0;
  double most_way_m = 40.0;
  double rolled_m = 0.0;
};

/// The stone `dt_s` later; as it is where dt_s is not a number above zero.
RollingStone rolled_on(RollingStone stone, double dt_s);

MoverPlace place_of(const RollingStone& stone, const HeightField& ground);

}  // namespace prairie
