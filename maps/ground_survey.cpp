#include "maps/ground_survey.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace prairie {
namespace {

constexpr int kOverviewNodes = 1024;  // an overview has at most so many cells a side

/// How far (cells of the overview) the values around a gap can reach into it below the overview's level: each
/// level spreads them by its sweeps and one cell of interpolation, and the levels' cells halve.
constexpr int kReachCells = kFillSweeps + 1;

std::size_t cells(int columns, int rows) {
  return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

constexpr HeightRange kNothing{std::numeric_limits<float>::infinity(),
                               -std::numeric_limits<float>::infinity()};

/// Widens each block next to a gap, or in one, by its neighbours as far as they can reach: what is filled is
/// a mean of measured nodes and overview cells no further away.
void include_filled(const FillLevel& overview, const std::vector<bool>& gappy,
                    std::vector<HeightRange>* blocks) {
  const int columns = overview.columns;
  const int rows = overview.rows;
  const auto index = [columns](int i, int j) { return cells(columns, j) + static_cast<std::size_t>(i); };
  std::vector<HeightRange> known = *blocks;
  for (std::size_t k = 0; k < known.size(); ++k) {
    known[k] = united(known[k], {overview.values[k], overview.values[k]});
  }
  std::vector<HeightRange> along(known.size(), kNothing);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      for (int x = std::max(0, i - kReachCells); x <= std::min(columns - 1, i + kReachCells); ++x) {
        along[index(i, j)] = united(along[index(i, j)], known[index(x, j)]);
      }
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      if (!gappy[index(i, j)]) continue;
      HeightRange& block = (*blocks)[index(i, j)];
      for (int y = std::max(0, j - kReachCells); y <= std::min(rows - 1, j + kReachCells); ++y) {
        block = united(block, along[index(i, y)]);
      }
    }
  }
}

/// A grid on disk whose gaps are filled as they are read: the part of `fill_nodata`'s pyramid below the
/// overview is built for a window around the block, wide enough that its edges do not reach the block.
class FilledSource : public NodeSource {
 public:
  FilledSource(NodeGrid measured, FillLevel overview, int level)
      : measured_(std::move(measured)), overview_(std::move(overview)), level_(level) {}

  void read(const NodeRect& rect, std::span<float> out) const override {
    measured_.read_block(rect, out);
    if (std::none_of(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(cells(rect.columns, rect.rows)),
                     [](float v) { return std::isnan(v); })) {
      return;
    }
    const NodeRect window = window_around(rect);
    const FillLevel filled = filled_window(window);
    for (int j = 0; j < rect.rows; ++j) {
      const float* row = filled.values.data() + cells(window.columns, rect.row - window.row + j) +
                         (rect.column - window.column);
      std::copy_n(row, rect.columns, out.begin() + static_cast<std::ptrdiff_t>(cells(rect.columns, j)));
    }
  }

 private:
  /// Begins on a corner of the overview's cells and ends on one or at the grid's border.
  NodeRect window_around(const NodeRect& rect) const {
    const int cell = 1 << level_;
    const int margin = kReachCells * cell;
    const int column = std::max(0, (rect.column - margin) / cell * cell);
    const int row = std::max(0, (rect.row - margin) / cell * cell);
    const auto end = [cell](int last, int count) { return std::min((last / cell + 1) * cell, count); };
    return {column, row, end(rect.column + rect.columns - 1 + margin, measured_.frame().columns) - column,
            end(rect.row + rect.rows - 1 + margin, measured_.frame().rows) - row};
  }

  FillLevel filled_window(const NodeRect& window) const {
    std::vector<FillLevel> levels(1);
    levels[0] = {window.columns, window.rows, std::vector<float>(cells(window.columns, window.rows))};
    measured_.read_block(window, levels[0].values);
    for (int k = 1; k < level_; ++k) {
      const FillLevel& last = levels.back();
      levels.push_back(coarser_level(last.columns, last.rows, last.values));
    }
    FillLevel coarser{(levels.back().columns + 1) / 2, (levels.back().rows + 1) / 2, {}};
    for (int j = 0; j < coarser.rows; ++j) {
      const float* row = overview_.values.data() + cells(overview_.columns, (window.row >> level_) + j) +
                         (window.column >> level_);
      coarser.values.insert(coarser.values.end(), row, row + coarser.columns);
    }
    for (std::size_t k = levels.size(); k-- > 0;) {
      fill_from_coarser(coarser, levels[k].columns, levels[k].rows, false, levels[k].values);
      coarser = std::move(levels[k]);
    }
    return coarser;
  }

  NodeGrid measured_;
  FillLevel overview_;
  int level_;
};

}  // namespace

GroundSurvey survey_ground(const NodeGrid& measured_m) {
  const GridFrame& frame = measured_m.frame();
  int level = 1;
  while (((std::max(frame.columns, frame.rows) - 1) >> level) + 1 > kOverviewNodes) ++level;
  const int cell = 1 << level;
  const int columns = ((frame.columns - 1) >> level) + 1;
  const int rows = ((frame.rows - 1) >> level) + 1;

  FillLevel overview{columns, rows, {}};
  overview.values.reserve(cells(columns, rows));
  std::vector<HeightRange> blocks(cells(columns, rows), kNothing);
  std::vector<bool> gappy(cells(columns, rows), false);
  HeightRange measured = kNothing;
  for (int row = 0; row < rows; ++row) {
    FillLevel strip{frame.columns, std::min(cell, frame.rows - row * cell), {}};
    strip.values.resize(cells(strip.columns, strip.rows));
    measured_m.read_block({0, row * cell, strip.columns, strip.rows}, strip.values);
    for (std::size_t k = 0; k < strip.values.size(); ++k) {
      const std::size_t column = k % static_cast<std::size_t>(strip.columns);
      const std::size_t block = cells(columns, row) + (column >> level);
      if (std::isnan(strip.values[k])) {
        gappy[block] = true;
      } else {
        blocks[block] = united(blocks[block], {strip.values[k], strip.values[k]});
      }
    }
    for (int k = 0; k < level; ++k) strip = coarser_level(strip.columns, strip.rows, strip.values);
    overview.values.insert(overview.values.end(), strip.values.begin(), strip.values.end());
  }
  for (const HeightRange& block : blocks) measured = united(measured, block);
  if (measured.min_m > measured.max_m) throw no_ground();

  const bool has_gaps = std::find(gappy.begin(), gappy.end(), true) != gappy.end();
  if (has_gaps) {
    fill_nodata(columns, rows, false, overview.values);
    include_filled(overview, gappy, &blocks);
  }
  return {measured, has_gaps, HeightBounds(cell, columns, rows, std::move(blocks)), std::move(overview),
          level};
}

NodeGrid fill_from_survey(const NodeGrid& measured_m, FillLevel overview, int overview_level) {
  return NodeGrid(measured_m.frame(), 1,
                  std::make_shared<FilledSource>(measured_m, std::move(overview), overview_level), false);
}

BadInput no_ground() {
  return BadInput("", "", "a height map without data", "at least one node with a height");
}

}  // namespace prairie
