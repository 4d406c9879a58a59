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

  bool is_marked(int column, int row) const {
    const auto i = static_cast<std::size_t>(column);
    return (words_[static_cast<std::size_t>(row) * words_per_row_ + i / 64] >> (i % 64) & 1u) != 0;
  }
  /// Whether a marked node lies in `rect`, which lies inside the grid.
  bool any(const NodeRect& rect) const;

 private:
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
};

}  // namespace prairie
