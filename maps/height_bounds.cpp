#include "maps/height_bounds.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

namespace prairie {
namespace {

constexpr int kBlockNodes = 8;
// A query looks at no more than this many blocks along one axis, and is then at most half as wide again as
// asked.
constexpr int kBlocksPerQuery = 4;

}  // namespace

HeightBounds::HeightBounds(int block_nodes, int block_columns, int block_rows,
                           std::vector<HeightRange> blocks)
    : block_nodes_(block_nodes) {
  assert(block_nodes > 0 && block_columns > 0 && block_rows > 0);
  assert(blocks.size() == static_cast<std::size_t>(block_columns) * static_cast<std::size_t>(block_rows));
  levels_.push_back({block_columns, block_rows, std::move(blocks)});
  while (levels_.back().columns > 1 || levels_.back().rows > 1) {
    const Level& fine = levels_.back();
    Level coarse{(fine.columns + 1) / 2, (fine.rows + 1) / 2, {}};
    coarse.blocks.reserve(static_cast<std::size_t>(coarse.columns) * static_cast<std::size_t>(coarse.rows));
    for (int j = 0; j < coarse.rows; ++j) {
      for (int i = 0; i < coarse.columns; ++i) {
        const auto block = [&fine](int x, int y) {
          const std::size_t column = static_cast<std::size_t>(std::min(x, fine.columns - 1));
          const std::size_t row = static_cast<std::size_t>(std::min(y, fine.rows - 1));
          return fine.blocks[row * static_cast<std::size_t>(fine.columns) + column];
        };
        coarse.blocks.push_back(united(united(block(2 * i, 2 * j), block(2 * i + 1, 2 * j)),
                                       united(block(2 * i, 2 * j + 1), block(2 * i + 1, 2 * j + 1))));
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

HeightBounds HeightBounds::of(const NodeGrid& grid) {
  const GridFrame& frame = grid.frame();
  const std::span<const float> values = grid.values();
  const int block_columns = (frame.columns + kBlockNodes - 1) / kBlockNodes;
  const int block_rows = (frame.rows + kBlockNodes - 1) / kBlockNodes;
  std::vector<HeightRange> blocks(static_cast<std::size_t>(block_columns) *
                                  static_cast<std::size_t>(block_rows));
  constexpr int kRowsAtOnce = 32;
  const auto fill_row = [&](int j) {
    for (int i = 0; i < block_columns; ++i) {
      const int columns = std::min(kBlockNodes, frame.columns - i * kBlockNodes);
      const int rows = std::min(kBlockNodes, frame.rows - j * kBlockNodes);
      const float* first =
          values.data() +
          static_cast<std::size_t>(j * kBlockNodes) * static_cast<std::size_t>(frame.columns) +
          i * kBlockNodes;
      HeightRange range{*first, *first};
      for (int y = 0; y < rows; ++y, first += frame.columns) {
        for (int x = 0; x < columns; ++x) range = united(range, {first[x], first[x]});
      }
      blocks[static_cast<std::size_t>(j) * static_cast<std::size_t>(block_columns) +
             static_cast<std::size_t>(i)] = range;
    }
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, block_rows, kRowsAtOnce),
                    [&](const tbb::blocked_range<int>& rows) {
                      for (int j = rows.begin(); j < rows.end(); ++j) fill_row(j);
                    });
  return HeightBounds(kBlockNodes, block_columns, block_rows, std::move(blocks));
}

HeightRange HeightBounds::over(const NodeRect& rect) const {
  assert(rect.columns > 0 && rect.rows > 0 && rect.column >= 0 && rect.row >= 0);
  int x0 = rect.column / block_nodes_;
  int y0 = rect.row / block_nodes_;
  int x1 = (rect.column + rect.columns - 1) / block_nodes_;
  int y1 = (rect.row + rect.rows - 1) / block_nodes_;
  std::size_t k = 0;
  while (std::max(x1 - x0, y1 - y0) >= kBlocksPerQuery) {
    x0 /= 2, y0 /= 2, x1 /= 2, y1 /= 2;
    ++k;
  }
  const Level& level = levels_[k];
  assert(x1 < level.columns && y1 < level.rows);
  const auto row = [&level](int y) {
    return level.blocks.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(level.columns);
  };
  HeightRange range = row(y0)[x0];
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) range = united(range, row(y)[x]);
  }
  return range;
}

}  // namespace prairie
