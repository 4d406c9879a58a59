#include "maps/nodata_fill.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "maps/node_index.h"

namespace prairie {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::size_t cell_index(int columns, int i, int j) {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
}

bool has_gap(const std::vector<float>& values) {
  return std::any_of(values.begin(), values.end(), [](float v) { return std::isnan(v); });
}

bool has_gap(const FillLevel& level) {
  return has_gap(level.heights_m) || has_gap(level.east_m) || has_gap(level.north_m);
}

/// Means of 2 × 2 cells, of those that have data.
std::vector<float> halved(int columns, int rows, const std::vector<float>& values) {
  std::vector<float> means;
  means.reserve(((static_cast<std::size_t>(columns) + 1) / 2) * ((static_cast<std::size_t>(rows) + 1) / 2));
  for (int j = 0; j < rows; j += 2) {
    for (int i = 0; i < columns; i += 2) {
      float sum = 0.0f;
      int count = 0;
      for (int y = j; y < std::min(j + 2, rows); ++y) {
        for (int x = i; x < std::min(i + 2, columns); ++x) {
          const float value = values[cell_index(columns, x, y)];
          if (std::isnan(value)) continue;
          sum += value;
          ++count;
        }
      }
      means.push_back(count > 0 ? sum / static_cast<float>(count) : kNaN);
    }
  }
  return means;
}

/// A gap and its neighbours, as indices into the level. Beyond a border the neighbour is the gap itself.
struct Gap {
  std::uint32_t self, west, east, south, north;
};

std::vector<Gap> find_gaps(const FillLevel& level, bool repeats, const std::vector<float>& values) {
  std::vector<Gap> gaps;
  const auto index = [&level](int i, int j) {
    return static_cast<std::uint32_t>(cell_index(level.columns, i, j));
  };
  for (int j = 0; j < level.rows; ++j) {
    for (int i = 0; i < level.columns; ++i) {
      if (!std::isnan(values[index(i, j)])) continue;
      gaps.push_back({index(i, j), index(border_index(i - 1, level.columns, repeats), j),
                      index(border_index(i + 1, level.columns, repeats), j),
                      index(i, border_index(j - 1, level.rows, repeats)),
                      index(i, border_index(j + 1, level.rows, repeats))});
    }
  }
  return gaps;
}

/// The four coarse cells around a fine one, whose centre lies a quarter of a coarse cell from that of the
/// nearest.
template <class Value>
float interpolated(const FillLevel& coarser, int columns, bool repeats, std::size_t fine,
                   const Value& value) {
  const int i = static_cast<int>(fine % static_cast<std::size_t>(columns));
  const int j = static_cast<int>(fine / static_cast<std::size_t>(columns));
  const int x = i / 2;
  const int y = j / 2;
  const int far_x = border_index(i % 2 == 0 ? x - 1 : x + 1, coarser.columns, repeats);
  const int far_y = border_index(j % 2 == 0 ? y - 1 : y + 1, coarser.rows, repeats);
  const auto at = [&](int column, int row) { return value(cell_index(coarser.columns, column, row)); };
  return 0.5625f * at(x, y) + 0.1875f * (at(far_x, y) + at(x, far_y)) + 0.0625f * at(far_x, far_y);
}

template <class Each>
void for_all(std::size_t count, const Each& each) {
  constexpr std::size_t kWorthAThread = 1 << 14;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kWorthAThread),
                    [&each](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t k = range.begin(); k != range.end(); ++k) each(k);
                    });
}

/// Jacobi sweeps: each gap becomes the mean of what `from` says of its four neighbours. In parallel, since
/// none sees what another becomes.
template <class From>
void relax(const std::vector<Gap>& gaps, std::vector<float>* values, const From& mean) {
  std::vector<float> next(gaps.size());
  for (int sweep = 0; sweep < kFillSweeps; ++sweep) {
    for_all(gaps.size(), [&](std::size_t k) { next[k] = mean(gaps[k]); });
    for_all(gaps.size(), [&](std::size_t k) { (*values)[gaps[k].self] = next[k]; });
  }
}

void fill_slopes(const FillLevel& coarser, const std::vector<float>& coarse, const FillLevel& level,
                 bool repeats, std::vector<float>* slopes) {
  const std::vector<Gap> gaps = find_gaps(level, repeats, *slopes);
  for_all(gaps.size(), [&](std::size_t k) {
    (*slopes)[gaps[k].self] = interpolated(coarser, level.columns, repeats, gaps[k].self,
                                           [&coarse](std::size_t cell) { return coarse[cell]; });
  });
  relax(gaps, slopes, [&slopes](const Gap& gap) {
    const std::vector<float>& s = *slopes;
    return 0.25f * ((s[gap.west] + s[gap.east]) + (s[gap.south] + s[gap.north]));
  });
}

void fill_heights(const FillLevel& coarser, float cell_nodes, bool repeats, FillLevel* level) {
  std::vector<float>& z = level->heights_m;
  const std::vector<float>& east = level->east_m;
  const std::vector<float>& north = level->north_m;
  const std::vector<Gap> gaps = find_gaps(*level, repeats, z);
  for_all(gaps.size(), [&](std::size_t k) {
    z[gaps[k].self] = interpolated(coarser, level->columns, repeats, gaps[k].self,
                                   [&coarser](std::size_t cell) { return coarser.heights_m[cell]; });
  });
  // Each neighbour says: my height, and the way from me to you at the mean of our slopes. Across a border
  // nobody says anything, so that the ground leaves the map with the slope it has.
  const float half = 0.5f * cell_nodes;
  relax(gaps, &z, [&](const Gap& gap) {
    const std::uint32_t self = gap.self;
    const float west = gap.west == self ? z[self] : z[gap.west] + half * (east[gap.west] + east[self]);
    const float from_east = gap.east == self ? z[self] : z[gap.east] - half * (east[gap.east] + east[self]);
    const float south = gap.south == self ? z[self] : z[gap.south] + half * (north[gap.south] + north[self]);
    const float from_north =
        gap.north == self ? z[self] : z[gap.north] - half * (north[gap.north] + north[self]);
    return 0.25f * ((west + from_east) + (south + from_north));
  });
}

}  // namespace

FillLevel finest_level(int columns, int rows, bool repeats, std::span<const float> heights_m) {
  const std::size_t count = heights_m.size();
  assert(count == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  FillLevel level{columns,
                  rows,
                  {heights_m.begin(), heights_m.end()},
                  std::vector<float>(count, kNaN),
                  std::vector<float>(count, kNaN)};
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const std::size_t self = cell_index(columns, i, j);
      if (std::isnan(heights_m[self])) continue;
      if (repeats || (i > 0 && i + 1 < columns)) {
        level.east_m[self] = 0.5f * (heights_m[cell_index(columns, wrapped_index(i + 1, columns), j)] -
                                     heights_m[cell_index(columns, wrapped_index(i - 1, columns), j)]);
      }
      if (repeats || (j > 0 && j + 1 < rows)) {
        level.north_m[self] = 0.5f * (heights_m[cell_index(columns, i, wrapped_index(j + 1, rows))] -
                                      heights_m[cell_index(columns, i, wrapped_index(j - 1, rows))]);
      }
    }
  }
  return level;
}

FillLevel coarser_level(const FillLevel& level) {
  return {(level.columns + 1) / 2, (level.rows + 1) / 2, halved(level.columns, level.rows, level.heights_m),
          halved(level.columns, level.rows, level.east_m), halved(level.columns, level.rows, level.north_m)};
}

void fill_from_coarser(const FillLevel& coarser, int cell_nodes, bool repeats, FillLevel* level) {
  fill_slopes(coarser, coarser.east_m, *level, repeats, &level->east_m);
  fill_slopes(coarser, coarser.north_m, *level, repeats, &level->north_m);
  fill_heights(coarser, static_cast<float>(cell_nodes), repeats, level);
}

void fill_level(int cell_nodes, bool repeats, FillLevel* level) {
  std::vector<FillLevel> coarser;
  const auto last = [&]() -> FillLevel& { return coarser.empty() ? *level : coarser.back(); };
  while (has_gap(last()) && (last().columns > 1 || last().rows > 1)) coarser.push_back(coarser_level(last()));
  // Where no node has two measured neighbours, nothing is known of slopes.
  for (std::vector<float>* slopes : {&last().east_m, &last().north_m}) {
    std::replace_if(
        slopes->begin(), slopes->end(), [](float v) { return std::isnan(v); }, 0.0f);
  }
  assert(!has_gap(last()));
  for (std::size_t k = coarser.size(); k-- > 0;) {
    FillLevel* finer = k > 0 ? &coarser[k - 1] : level;
    fill_from_coarser(coarser[k], cell_nodes << k, repeats, finer);
  }
}

void fill_nodata(int columns, int rows, bool repeats, std::span<float> heights_m) {
  if (std::none_of(heights_m.begin(), heights_m.end(), [](float v) { return std::isnan(v); })) return;
  FillLevel level = finest_level(columns, rows, repeats, heights_m);
  fill_level(1, repeats, &level);
  std::copy(level.heights_m.begin(), level.heights_m.end(), heights_m.begin());
}

}  // namespace prairie
