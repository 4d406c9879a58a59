// Fills the gaps of a height map so that the ground is defined everywhere and runs on as it does beside the
// gap: nothing may look like a cliff or a dam where the survey merely ended. Slopes come first: those of
// measured ground spread into the gaps as a membrane would. Then the heights whose slopes come closest to
// these: Poisson's equation ∇²z = div s, with measured nodes held fixed (Pérez et al. 2003, Poisson Image
// Editing, eq. 3). A membrane of the heights alone is steep wherever the edge of a gap slopes along itself:
// up to 4 times the slope of a plane half of which is missing.
//
// Solved by pull–push: means of 2 × 2 cells up to a level without gaps, then down again; on every level the
// gaps start from the coarser level, bilinearly, and a few Jacobi sweeps smooth them. Every step is local and
// aligned to node (0, 0), so that a window of a map that does not fit into memory can be filled alone, with
// the same bits (maps/filled_heights.h).
#pragma once

#include <span>
#include <vector>

namespace prairie {

/// One level of the pyramid, row by row; NaN = gap. Slopes are rises per node of the finest level, metres.
struct FillLevel {
  int columns = 0;
  int rows = 0;
  std::vector<float> heights_m;
  std::vector<float> east_m;
  std::vector<float> north_m;
};

/// Sweeps on each level. Fewer leave the coarser levels' cells visible; more reach further, which windows pay
/// for.
inline constexpr int kFillSweeps = 8;

/// The finest level: heights as given, slopes from node to node where both neighbours are measured.
FillLevel finest_level(int columns, int rows, bool repeats, std::span<const float> heights_m);

/// The next coarser level: means over the 2 × 2 cells that have data; NaN where none has.
FillLevel coarser_level(const FillLevel& level);

/// Fills the gaps of `level`, whose cells are `cell_nodes` nodes wide, from the coarser level, which has
/// none.
void fill_from_coarser(const FillLevel& coarser, int cell_nodes, bool repeats, FillLevel* level);

/// Fills every gap of a level by way of all coarser ones. At least one cell has a height.
void fill_level(int cell_nodes, bool repeats, FillLevel* level);

/// Fills every gap (NaN) of a grid of heights in place. At least one node has a height. `repeats`: opposite
/// borders are neighbours. Takes as much memory again as three grids while it works.
void fill_nodata(int columns, int rows, bool repeats, std::span<float> heights_m);

}  // namespace prairie
