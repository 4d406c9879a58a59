// The strips around a tile (G03 §3.4), ready for the renderer: ground along the sides, density and features.
// Deviation: density follows the map along a strip instead of being one number a tile.
#pragma once

#include <vector>

#include "generator/meadow.h"
#include "generator/tiles.h"
#include "shaders/shared/layouts.h"

namespace prairie {

/// Densities that stand for a tile's blades: of each species (blades per m²) the means over its four cells.
struct TileDensity {
  std::vector<glm::vec4> cells_per_m2;  // per species: south-west, south-east, north-west, north-east
  double mean_per_m2(std::size_t species) const;
  double sum_per_m2() const;
};

TileDensity tile_density(const Meadow& meadow, TileId tile);

/// Appends one StripTile for each species that grows on the tile. `grown`: how much of the strips stands out
/// of the ground.
void append_strips(const Meadow& meadow, TileId tile, const TileDensity& density, glm::dvec3 eye_m,
                   float grown, std::vector<StripTile>& strips);

}  // namespace prairie
