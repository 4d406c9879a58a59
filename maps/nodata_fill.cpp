#include "maps/nodata_fill.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "maps/node_index.h"

namespace prairie {
namespace {

/// The two coarse cells on either side of a fine one, whose centre lies a quarter of a coarse cell beside
/// `near`.
struct Neighbours {
  int near = 0;
  int far = 0;
};

Neighbours coarse_neighbours(int fine, int coarse_count, bool repeats) {
  const int near = fine / 2;
  const int far = fine % 2 == 0 ? near - 1 : near + 1;
  return {near, border_index(far, coarse_count, repeats)};
}

/// A gap and its neighbours to the west, east, south and north, as indices into the level.
struct Gap {
  std::size_t self, west, east, south, north;
};

std::vector<Gap> find_gaps(int columns, int rows, bool repeats, std::span<const float> values) {
  const auto index = [columns](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
  };
  std::vector<Gap> gaps;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      if (!std::isnan(values[index(i, j)])) continue;
      gaps.push_back({index(i, j), index(border_index(i - 1, columns, repeats), j),
                      index(border_index(i + 1, columns, repeats), j),
                      index(i, border_index(j - 1, rows, repeats)),
                      index(i, border_index(j + 1, rows, repeats))});
    }
  }
  return gaps;
}

}  // namespace

FillLevel coarser_level(int columns, int rows, std::span<const float> values) {
  FillLevel coarser{(columns + 1) / 2, (rows + 1) / 2, {}};
  coarser.values.reserve(static_cast<std::size_t>(coarser.columns) * static_cast<std::size_t>(coarser.rows));
  for (int j = 0; j < coarser.rows; ++j) {
    for (int i = 0; i < coarser.columns; ++i) {
      float sum = 0.0f;
      int count = 0;
      for (int y = 2 * j; y < std::min(2 * j + 2, rows); ++y) {
        for (int x = 2 * i; x < std::min(2 * i + 2, columns); ++x) {
          const float v = values[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                                 static_cast<std::size_t>(x)];
          if (std::isnan(v)) continue;
          sum += v;
          ++count;
        }
      }
      coarser.values.push_back(count > 0 ? sum / static_cast<float>(count) : std::nanf(""));
    }
  }
  return coarser;
}

void fill_from_coarser(const FillLevel& coarser, int columns, int rows, bool repeats,
                       std::span<float> values) {
  const std::vector<Gap> gaps = find_gaps(columns, rows, repeats, values);
  if (gaps.empty()) return;
  const auto coarse = [&coarser](int i, int j) {
    return coarser.values[static_cast<std::size_t>(j) * static_cast<std::size_t>(coarser.columns) +
                          static_cast<std::size_t>(i)];
  };
  for (const Gap& gap : gaps) {
    const int i = static_cast<int>(gap.self % static_cast<std::size_t>(columns));
    const int j = static_cast<int>(gap.self / static_cast<std::size_t>(columns));
    const Neighbours x = coarse_neighbours(i, coarser.columns, repeats);
    const Neighbours y = coarse_neighbours(j, coarser.rows, repeats);
    values[gap.self] = 0.5625f * coarse(x.near, y.near) +
                       0.1875f * (coarse(x.far, y.near) + coarse(x.near, y.far)) +
                       0.0625f * coarse(x.far, y.far);
  }
  std::vector<float> next(gaps.size());
  for (int sweep = 0; sweep < kFillSweeps; ++sweep) {
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      const Gap& gap = gaps[k];
      next[k] = 0.25f * ((values[gap.west] + values[gap.east]) + (values[gap.south] + values[gap.north]));
    }
    for (std::size_t k = 0; k < gaps.size(); ++k) values[gaps[k].self] = next[k];
  }
}

void fill_nodata(int columns, int rows, bool repeats, std::span<float> values) {
  assert(values.size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const auto has_gap = [](std::span<const float> level) {
    return std::any_of(level.begin(), level.end(), [](float v) { return std::isnan(v); });
  };
  if (!has_gap(values)) return;
  std::vector<FillLevel> levels;
  levels.push_back(coarser_level(columns, rows, values));
  while (has_gap(levels.back().values)) {
    const FillLevel& last = levels.back();
    assert(last.columns > 1 || last.rows > 1);
    levels.push_back(coarser_level(last.columns, last.rows, last.values));
  }
  for (std::size_t k = levels.size() - 1; k > 0; --k) {
    FillLevel& finer = levels[k - 1];
    fill_from_coarser(levels[k], finer.columns, finer.rows, repeats, finer.values);
  }
  fill_from_coarser(levels.front(), columns, rows, repeats, values);
}

}  // namespace prairie
