// What stands still in the way of walkers, ready to be asked what is near a place: a grid whose cells list
// the footprints in their reach.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "agents/footprint.h"

namespace prairie {

class ObstacleMap {
 public:
  /// Whatever is farther from a place than `reach_m` does not have to be found from there.
  ObstacleMap(std::vector<Footprint> footprints, double reach_m);

  const std::vector<Footprint>& footprints() const { return footprints_; }

  /// Indices of footprints, ascending: all within the reach of the place, and maybe others.
  std::span<const std::uint32_t> near(glm::dvec2 position_m) const;
  const FootprintBox& box(std::uint32_t index) const { return boxes_[index]; }

 private:
  struct Cell {
    std::int64_t key;
    std::uint32_t first, end;  // in indices_
  };

  std::vector<Footprint> footprints_;
  std::vector<FootprintBox> boxes_;
  std::vector<Cell> cells_;  // those in whose reach something stands, by key
  std::vector<std::uint32_t> indices_;
};

}  // namespace prairie
