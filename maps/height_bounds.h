// Lowest and highest node over any rectangle of a grid, without visiting its nodes: a pyramid of blocks, each
// level holding the extremes of 2 × 2 blocks of the one below.
#pragma once

#include <span>
#include <vector>

#include "maps/height_range.h"
#include "maps/node_grid.h"

namespace prairie {

class HeightBounds {
 public:
  /// `blocks`: extremes of squares of `block_nodes`² nodes, row by row from south, `block_columns` ×
  /// `block_rows`.
  HeightBounds(int block_nodes, int block_columns, int block_rows, std::vector<HeightRange> blocks);
  /// Over a grid in memory, one channel, no gaps.
  static HeightBounds of(const NodeGrid& grid);

  /// Contains every node of `rect`, which lies inside the grid; at most a few blocks too wide.
  HeightRange over(const NodeRect& rect) const;

 private:
  struct Level {
    int columns = 0;
    int rows = 0;
    std::vector<HeightRange> blocks;
  };
  int block_nodes_ = 1;
  std::vector<Level> levels_;
};

}  // namespace prairie
