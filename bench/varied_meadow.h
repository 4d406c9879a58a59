// The meadow on which planting is measured: one species, a density of about 1000 blades per m² that varies
// from node to node.
#pragma once

#include "generator/meadow.h"

namespace prairie {

inline constexpr int kVariedMeadowTiles = 16;  // along a side

Meadow varied_meadow();

}  // namespace prairie
