// A map's values on the lattice of one cell: (m + 1) × (m + 1) points, m patches along a side. Where the
// map's own nodes lie on the lattice the values are exact; a finer map is box-filtered, so that no blade
// count depends on which of its nodes happen to be hit.
#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "maps/node_grid.h"

namespace prairie {

inline constexpr int kMaxPatches = 8;

/// The smallest m ∈ {1, 2, 4, 8} whose lattice holds every node of the map inside any cell of side `cell_m`;
/// where none does, one that samples the map at least twice per node.
int patches_for(const NodeGrid& map, double cell_m);

/// Writes the lattice's values, channels interleaved, row by row from south: (m + 1)² · channels floats; NaN
/// where the map has no data or ends.
void sample_cell_lattice(const NodeGrid& map, glm::dvec2 cell_origin_m, double cell_m, int patches,
                         std::span<float> out);

}  // namespace prairie
