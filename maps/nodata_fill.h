// Fills the gaps of a height map so that the ground is defined everywhere: a membrane stretched between the
// measured nodes. Pull–push: means of 2 × 2 cells up to a level without gaps, then down again; on every level
// the gaps start from the coarser level, bilinearly, and a few Jacobi sweeps of the Laplace equation smooth
// them, measured cells held fixed.
//
// A membrane and not a thin plate: it never leaves the range of its surroundings, so that half an empty map
// does not run off into hills that nobody measured. Every step is local and aligned to node (0, 0), so that a
// window of a map that does not fit into memory can be filled alone, with the same result
// (maps/filled_source.h).
#pragma once

#include <span>
#include <vector>

namespace prairie {

/// One level of the pyramid: cells row by row, NaN = gap.
struct FillLevel {
  int columns = 0;
  int rows = 0;
  std::vector<float> values;
};

/// Sweeps on each level. Fewer leave the coarser levels' cells visible; more reach further, which windows pay
/// for.
inline constexpr int kFillSweeps = 8;

/// The next coarser level: means over the 2 × 2 cells that have data; NaN where none has.
FillLevel coarser_level(int columns, int rows, std::span<const float> values);

/// Fills the gaps of `values` from the coarser level, which has none.
void fill_from_coarser(const FillLevel& coarser, int columns, int rows, bool repeats,
                       std::span<float> values);

/// Fills every gap (NaN) of a grid in place. At least one node has data. `repeats`: opposite borders are
/// neighbours.
void fill_nodata(int columns, int rows, bool repeats, std::span<float> values);

}  // namespace prairie
