// The integral of a density map, exactly: what planting is compared with.
#pragma once

#include <glm/vec2.hpp>

#include "maps/node_grid.h"

namespace prairie {

/// Integral of the bilinear surface over the box, cut along the map's node lines; between them the value in
/// the middle of a rectangle is its mean.
double density_integral(const NodeGrid& map, glm::dvec2 min_m, glm::dvec2 max_m);

}  // namespace prairie
