// One bit per node of a grid; remembers which nodes were measured at a thirty-second of the memory of the
// values.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "maps/node_grid.h"

namespace prairie {

class NodeMask {
 public:
  /// Marks the NaN of `values` (one channel, row by row).
  NodeMask(int columns, int rows, std::span<const float> values);

  /// Whether a marked node lies in `rect`, which lies inside the grid.
  bool any(const NodeRect& rect) const;

 private:
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
};

}  // namespace prairie
