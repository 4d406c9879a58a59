#include "maps/ground_survey.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "files/error.h"

namespace prairie {
namespace {

constexpr int kOverviewNodes = 1024;  // an overview has at most so many cells a side

constexpr HeightRange kNothing{std::numeric_limits<float>::infinity(),
                               -std::numeric_limits<float>::infinity()};

std::size_t cells(int columns, int rows) {
  return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

/// What is known of the nodes of one cell of the overview.
struct CellCensus {
  HeightRange heights_m = kNothing;
  float steepest_m = 0.0f;  // of the rises from node to node, east or north
  bool has_gap = false;
};

CellCensus united(const CellCensus& a, const CellCensus& b) {
  return {united(a.heights_m, b.heights_m), std::max(a.steepest_m, b.steepest_m), a.has_gap || b.has_gap};
}

void take(CellCensus* census, float height_m, float east_m, float north_m) {
  if (!std::isnan(height_m)) census->heights_m = united(census->heights_m, {height_m, height_m});
  for (const float slope_m : {east_m, north_m}) {
    if (!std::isnan(slope_m)) census->steepest_m = std::max(census->steepest_m, std::abs(slope_m));
  }
}

/// The extremes of all cells within reach of each cell.
std::vector<CellCensus> within_reach(int columns, int rows, const std::vector<CellCensus>& census) {
  const auto index = [columns](int i, int j) { return cells(columns, j) + static_cast<std::size_t>(i); };
  std::vector<CellCensus> along(census.size()), result(census.size());
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int last = std::min(columns - 1, i + kFillReachCells);
      for (int x = std::max(0, i - kFillReachCells); x <= last; ++x) {
        along[index(i, j)] = united(along[index(i, j)], census[index(x, j)]);
      }
    }
  }
  for (int j = 0; j < rows; ++j) {
    const int last = std::min(rows - 1, j + kFillReachCells);
    for (int i = 0; i < columns; ++i) {
      for (int y = std::max(0, j - kFillReachCells); y <= last; ++y) {
        result[index(i, j)] = united(result[index(i, j)], along[index(i, y)]);
      }
    }
  }
  return result;
}

/// Bounds of each cell's nodes, filled ones included: those are means of what lies within reach, moved on
/// each level by no more than one cell's rise per sweep.
std::vector<HeightRange> cell_bounds(const GroundOverview& overview, std::vector<CellCensus> census) {
  std::vector<HeightRange> bounds;
  for (const CellCensus& cell : census) bounds.push_back(cell.heights_m);
  for (std::size_t k = 0; k < census.size(); ++k) {
    take(&census[k], overview.cells.heights_m[k], overview.cells.east_m[k], overview.cells.north_m[k]);
  }
  const std::vector<CellCensus> reach = within_reach(overview.cells.columns, overview.cells.rows, census);
  const float cell_sweeps = static_cast<float>(kFillSweeps << overview.level);
  for (std::size_t k = 0; k < census.size(); ++k) {
    if (!census[k].has_gap) continue;
    const float rise_m = reach[k].steepest_m * cell_sweeps;
    bounds[k] = united(bounds[k], {reach[k].heights_m.min_m - rise_m, reach[k].heights_m.max_m + rise_m});
  }
  return bounds;
}

/// Copies one strip out of a taller one.
FillLevel rows_of(const FillLevel& level, int first, int count) {
  const auto cut = [&](const std::vector<float>& values) {
    const float* begin = values.data() + cells(level.columns, first);
    return std::vector<float>(begin, begin + cells(level.columns, count));
  };
  return {level.columns, count, cut(level.heights_m), cut(level.east_m), cut(level.north_m)};
}

}  // namespace

GroundSurvey survey_ground(const NodeGrid& measured_m) {
  const GridFrame& frame = measured_m.frame();
  GroundOverview overview;
  while (((std::max(frame.columns, frame.rows) - 1) >> overview.level) + 1 > kOverviewNodes) ++overview.level;
  const int level = overview.level;
  const int cell = 1 << level;
  const int columns = ((frame.columns - 1) >> level) + 1;
  const int rows = ((frame.rows - 1) >> level) + 1;
  overview.cells.columns = columns;
  overview.cells.rows = rows;

  std::vector<CellCensus> census(cells(columns, rows));
  for (std::vector<float>* values :
       {&overview.cells.heights_m, &overview.cells.east_m, &overview.cells.north_m})
    values->resize(cells(columns, rows));
  tbb::parallel_for(0, rows, [&](int row) {
    // One row more on either side, for the slopes.
    const int first = std::max(0, row * cell - 1);
    const int last = std::min(frame.rows, (row + 1) * cell + 1);
    std::vector<float> nodes(cells(frame.columns, last - first));
    measured_m.read_block({0, first, frame.columns, last - first}, nodes);
    FillLevel strip = rows_of(finest_level(frame.columns, last - first, false, nodes), row * cell - first,
                              std::min(cell, frame.rows - row * cell));
    for (std::size_t k = 0; k < strip.heights_m.size(); ++k) {
      const std::size_t column = k % static_cast<std::size_t>(strip.columns);
      CellCensus& here = census[cells(columns, row) + (column >> level)];
      take(&here, strip.heights_m[k], strip.east_m[k], strip.north_m[k]);
      if (std::isnan(strip.heights_m[k])) here.has_gap = true;
    }
    for (int k = 0; k < level; ++k) strip = coarser_level(strip);
    const auto put = [&](const std::vector<float>& from, std::vector<float>& to) {
      std::ranges::copy(from, to.begin() + static_cast<std::ptrdiff_t>(cells(columns, row)));
    };
    put(strip.heights_m, overview.cells.heights_m);
    put(strip.east_m, overview.cells.east_m);
    put(strip.north_m, overview.cells.north_m);
  });

  CellCensus all;
  for (const CellCensus& here : census) all = united(all, here);
  if (all.heights_m.min_m > all.heights_m.max_m) {
    throw BadInput("", "", "a height map without data", "at least one node with a height");
  }
  if (all.has_gap) fill_level(cell, false, &overview.cells);
  std::vector<HeightRange> bounds = cell_bounds(overview, std::move(census));
  return {all.heights_m, all.has_gap, HeightBounds(cell, columns, rows, std::move(bounds)),
          std::move(overview)};
}

}  // namespace prairie
