// Densities per square metre of the ground's own surface, as people on a slope count them, in place of those
// per square metre of map, which planting works with: a square metre of map holds √(1 + |∇z|²) of surface.
#pragma once

#include "maps/height_field.h"
#include "maps/node_grid.h"

namespace prairie {

/// Per m² of map. The nodes are those of the density or, where they are finer, of the ground; level ground
/// leaves a density as it is. Takes as much memory as that many floats.
NodeGrid density_per_map(const NodeGrid& per_surface_m2, const HeightField& ground);

}  // namespace prairie
