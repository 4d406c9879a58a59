// The heights of a map that does not fit into memory, its gaps filled page by page as they are read.
#pragma once

#include <memory>
#include <span>

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

class NodeMask;

/// The grid without its gaps, with the bits that `fill_nodata` would give the whole of it (unless it repeats:
/// then the gap that crosses the border is filled on either side alone).
NodeGrid filled_heights(const NodeGrid& measured_m, GroundOverview overview);

/// Fills heights in memory, in place, with the bits that `fill_nodata` gives a grid that does not repeat, but
/// in a fixed amount of memory. `gaps` marks them. At least one node has a height.
void fill_page_by_page(const GridFrame& frame, const NodeMask& gaps, std::span<float> heights_m);

}  // namespace prairie
