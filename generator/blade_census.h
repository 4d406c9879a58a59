// How much grows on a field in all: sums over the maps' nodes, so that the cost follows the maps and never
// the area.
#pragma once

#include <vector>

#include "generator/meadow.h"

namespace prairie {

struct BladeCensus {
  std::vector<double> blades;  // per species: the integral of its density over the ground that is planted
  double densest_per_m2 =
      0.0;  // of all species together; the mean over about a tile, or a cell of a coarser map
};

/// What planting all tiles of the field (of one period where it repeats) comes to on average: exact where the
/// maps' nodes lie on the lattice that cells are planted by (generator/cell_lattice.h), else as near as the
/// maps themselves are followed; strips narrower than a patch along gaps and borders aside. Runs in parallel;
/// the same sums for every number of threads.
BladeCensus blade_census(const Meadow& meadow);

}  // namespace prairie
