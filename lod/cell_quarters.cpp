#include "lod/cell_quarters.h"

#include <algorithm>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

struct Range {
  float low;
  float high;
};

// Layout of the table: shaders/kernels/warp.glsl.
struct Table {
  const float* values;
  std::uint32_t patches;
  const float* row(std::uint32_t row) const { return values + 4 * row; }
  const float* node(std::uint32_t row, std::uint32_t column) const {
    return values + 4 * (patches + row * (patches + 1) + column);
  }
};

// Where along a row's lower (edge 0) or upper edge the density's integral reaches its half, in patches: the
// least and the greatest such place, since it may stand still over a gap.
Range edge_median(const Table& table, std::uint32_t row, int edge) {
  const float half = 0.5f * table.row(row)[1 + edge];
  Kernels kernels;
  const auto place = [&](std::uint32_t column) {
    const float west = table.node(row, column)[2 + edge];
    const float east = table.node(row, column + 1)[2 + edge];
    const float mass = table.node(row, column + 1)[edge] - table.node(row, column)[edge];
    const float share = kernels.saturate((half - table.node(row, column)[edge]) / std::max(mass, 1e-30f));
    return static_cast<float>(column) + kernels.linear_density_root(share, west, east);
  };
  constexpr float kSlack = 1e-5f;
  std::uint32_t first = 0;
  while (first + 1 < table.patches && table.node(row, first + 1)[edge] < half * (1.0f - kSlack)) ++first;
  std::uint32_t last = table.patches - 1;
  while (last > first && table.node(row, last)[edge] > half * (1.0f + kSlack)) --last;
  return {place(first), place(last)};
}

// The conditional's median lies, at any height of a row, between its medians along the row's edges: its
// prefix sums are linear between them.
Range median_x(const Table& table) {
  Range range{static_cast<float>(table.patches), 0.0f};
  for (std::uint32_t row = 0; row < table.patches; ++row) {
    for (const int edge : {0, 1}) {
      if (table.row(row)[1 + edge] <= 0.0f) {
        // Nothing stands on the edge itself, but next to it the other edge's median holds alone.
        continue;
      }
      const Range edge_range = edge_median(table, row, edge);
      range.low = std::min(range.low, edge_range.low);
      range.high = std::max(range.high, edge_range.high);
    }
  }
  return range;
}

}  // namespace

std::array<CellQuarter, 4> quarters_of(const PlantedCell& cell, const std::vector<float>& tables) {
  constexpr float kSlackM = 1e-3f;  // of the planting kernel's rounding
  Kernels kernels{tables.data()};
  const Table table{tables.data() + 4 * static_cast<std::size_t>(cell.density_table), cell.patches};
  const float middle_y = kernels.warp_to_density(cell.density_table, cell.patches, {0.5f, 0.5f}).patch_xy.y;
  const Range middle_x = median_x(table);
  std::array<CellQuarter, 4> quarters;
  for (std::uint32_t n = 0; n < 4; ++n) {
    const std::uint32_t east = n % 2;
    const std::uint32_t north = n / 2;
    CellQuarter& quarter = quarters[n];
    quarter.code = kernels.quarter_code(east, north, cell.key.x);
    quarter.min_m = {east == 1 ? cell.patch_m * middle_x.low - kSlackM : 0.0f,
                     north == 1 ? cell.patch_m * middle_y - kSlackM : 0.0f};
    quarter.max_m = {east == 1 ? cell.side_m : cell.patch_m * middle_x.high + kSlackM,
                     north == 1 ? cell.side_m : cell.patch_m * middle_y + kSlackM};
  }
  return quarters;
}

std::uint32_t drawn_in_quarter(std::uint32_t code, std::uint32_t drawn) {
  std::uint32_t count = drawn / 4;
  Kernels kernels;
  if (kernels.quarter_index(code, count) < drawn) ++count;
  return count;
}

}  // namespace prairie
