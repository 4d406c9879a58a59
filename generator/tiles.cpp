#include "generator/tiles.h"

#include <algorithm>
#include <cmath>

namespace prairie {

TileRange tiles_of(const Meadow& meadow) {
  const auto last = [&](double extent_m) {
    return std::max(0, static_cast<int>(std::ceil(extent_m / meadow.tile_m - 1e-9)) - 1);
  };
  return {{0, 0}, {last(meadow.extent_m.x), last(meadow.extent_m.y)}};
}

glm::dvec2 tile_origin_m(const Meadow& meadow, TileId tile) {
  return meadow.tile_m * glm::dvec2(tile.i, tile.j);
}

glm::vec2 cell_offset_m(const Meadow& meadow, int cell) {
  const double cell_m = meadow.tile_m / kCellsPerSide;
  return glm::vec2(cell_m * glm::dvec2(cell % kCellsPerSide, cell / kCellsPerSide));
}

}  // namespace prairie
