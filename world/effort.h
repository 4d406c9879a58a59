// How dear a step through vegetation is: tall and dense sward slows walkers (G03 §1).
//
// Effort relative to bare ground, after the terrain factors of Soule and Goldman 1972 ("Terrain coefficients
// for energy cost prediction"): 1.2 for light brush, 1.5 for heavy brush, 1.8 where one wades. It grows with
// the height of the sward, in metres, by half of the share of the ground that its blades cover (1 − e^(−leaf
// area index)).
#pragma once

#include <glm/vec2.hpp>

#include "generator/meadow.h"

namespace prairie {

/// 1…1.8. Safe to ask from several threads.
double effort_at(const Meadow& meadow, glm::dvec2 position_m);

}  // namespace prairie
