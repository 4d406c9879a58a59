// Square cells of the ground, in which things are looked up.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

namespace prairie {

struct PlanCell {
  int i = 0, j = 0;  // east, north
};

/// Of places at most 2³⁰ cells from the scene's origin.
inline PlanCell plan_cell(glm::dvec2 position_m, double cell_m) {
  return {static_cast<int>(std::floor(position_m.x / cell_m)),
          static_cast<int>(std::floor(position_m.y / cell_m))};
}

/// Rises by rows from south, in a row from west.
inline std::int64_t key_of(PlanCell cell) {
  return (static_cast<std::int64_t>(cell.j) << 32) + cell.i;
}

}  // namespace prairie
