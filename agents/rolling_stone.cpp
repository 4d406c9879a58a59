#include "agents/rolling_stone.h"

#include <algorithm>

#include "animation/heading.h"

namespace prairie {

RollingStone rolled_on(RollingStone stone, double dt_s) {
  if (!(dt_s > 0.0)) return stone;
  stone.rolled_m = std::min(stone.rolled_m + stone.speed_m_per_s * dt_s, stone.most_way_m);
  return stone;
}

MoverPlace place_of(const RollingStone& stone, const HeightField& ground) {
  const glm::dvec2 forward = direction_of(stone.heading_rad);
  return stone_place(ground, stone.radius_m, stone.start_m + stone.rolled_m * forward, forward,
                     stone.rolled_m);
}

}  // namespace prairie
