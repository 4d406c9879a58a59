#include "bench/varied_meadow.h"

#include <cmath>
#include <vector>

namespace prairie {

Meadow varied_meadow() {
  Meadow meadow;
  const double side_m = kVariedMeadowTiles * meadow.tile_m;
  meadow.extent_m = {side_m, side_m};
  GridFrame frame;
  frame.columns = frame.rows = static_cast<int>(side_m) + 1;
  std::vector<float> density_per_m2;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      density_per_m2.push_back(1000.0f + 500.0f * std::sin(0.7f * static_cast<float>(column)) *
                                             std::cos(0.4f * static_cast<float>(row)));
    }
  }
  PlantedSpecies grass;
  grass.species.name = "grass";
  grass.species.params.height_m = 0.5f;
  grass.species.params.height_spread = 0.3f;
  grass.species.params.width_m = 0.006f;
  grass.species.params.clump_m = 0.5f;
  grass.species.params.clump_strength = 0.5f;
  grass.density_per_m2 = NodeGrid(frame, 1, density_per_m2);
  meadow.species.push_back(grass);
  return meadow;
}

}  // namespace prairie
