// The heights of a map that does not fit into memory, its gaps filled page by page as they are read.
#pragma once

#include <memory>

#include "maps/nodata_fill.h"
#include "maps/node_grid.h"

namespace prairie {

/// The whole map at a coarse level, filled: cells of 2^level nodes.
struct GroundOverview {
  int level = 1;
  FillLevel cells;
};

/// How far, in cells of the overview, a value can reach on its way down from the overview to the nodes: each
/// level spreads slopes by its sweeps and a cell of interpolation, then heights by as much again, and cells
/// halve.
inline constexpr int kFillReachCells = 2 * (kFillSweeps + 1);

/// The grid without its gaps, with the bits that `fill_nodata` would give the whole of it (unless it repeats:
/// then the gap that crosses the border is filled on either side alone).
NodeGrid filled_heights(const NodeGrid& measured_m, GroundOverview overview);

}  // namespace prairie
