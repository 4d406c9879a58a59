#include "generator/cell_lattice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace prairie {
namespace {

constexpr double kNodeTolerance = 1e-6;  // of a spacing: positions this close to a node are the node

bool is_whole(double x) {
  return std::abs(x - std::round(x)) < kNodeTolerance;
}

bool lattice_holds_nodes(const GridFrame& frame, double step_m) {
  return frame.spacing_m >= step_m * (1.0 - kNodeTolerance) && is_whole(frame.spacing_m / step_m) &&
         is_whole(frame.origin_m.x / step_m) && is_whole(frame.origin_m.y / step_m);
}

// One axis of the lattice: which nodes contribute to each point, with which weights.
struct AxisSample {
  int first = 0;  // node index
  int count = 0;  // 0: beyond the map
  double offset = 0.0;
};

AxisSample axis_sample(double node, double half_width, int nodes, bool repeats) {
  AxisSample sample;
  if (!repeats) {
    if (node < -kNodeTolerance || node > nodes - 1 + kNodeTolerance) return sample;
    node = std::clamp(node, 0.0, static_cast<double>(nodes - 1));
  }
  if (is_whole(node)) node = std::round(node);
  if (half_width > 0.5) {
    double low = node - half_width;
    double high = node + half_width;
    if (!repeats) {
      low = std::max(low, 0.0);
      high = std::min(high, static_cast<double>(nodes - 1));
    }
    sample.first = static_cast<int>(std::ceil(low - kNodeTolerance));
    sample.count = static_cast<int>(std::floor(high + kNodeTolerance)) - sample.first + 1;
    return sample;
  }
  sample.first = static_cast<int>(std::floor(node));
  sample.offset = node - sample.first;
  sample.count = sample.offset > 0.0 ? 2 : 1;
  return sample;
}

double axis_weight(const AxisSample& sample, int n, bool filtered) {
  if (filtered) return 1.0 / sample.count;
  return n == 0 ? 1.0 - sample.offset : sample.offset;
}

}  // namespace

int patches_for(const NodeGrid& map, double cell_m) {
  if (map.is_uniform()) return 1;
  for (int patches = 1; patches <= kMaxPatches; patches *= 2) {
    if (lattice_holds_nodes(map.frame(), cell_m / patches)) return patches;
  }
  int patches = 1;
  while (patches < kMaxPatches && cell_m / patches > 0.5 * map.frame().spacing_m) patches *= 2;
  return patches;
}

void sample_cell_lattice(const NodeGrid& map, glm::dvec2 cell_origin_m, double cell_m, int patches,
                         std::span<float> out) {
  const int side = patches + 1;
  const int channels = map.channels();
  assert(out.size() == static_cast<std::size_t>(side * side * channels));
  if (map.is_uniform()) {
    std::fill(out.begin(), out.end(), map.sample({0.0, 0.0}));
    return;
  }
  const GridFrame& frame = map.frame();
  const double step = cell_m / patches / frame.spacing_m;  // in nodes
  const double half_width = 0.5 * step;
  const bool filtered = half_width > 0.5;
  const glm::dvec2 start = (cell_origin_m - frame.origin_m) / frame.spacing_m;

  AxisSample columns[kMaxPatches + 1];
  AxisSample rows[kMaxPatches + 1];
  NodeRect rect{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), 0, 0};
  int column_end = std::numeric_limits<int>::min();
  int row_end = std::numeric_limits<int>::min();
  for (int n = 0; n < side; ++n) {
    columns[n] = axis_sample(start.x + n * step, half_width, frame.columns, frame.repeats);
    rows[n] = axis_sample(start.y + n * step, half_width, frame.rows, frame.repeats);
    if (columns[n].count > 0) {
      rect.column = std::min(rect.column, columns[n].first);
      column_end = std::max(column_end, columns[n].first + columns[n].count);
    }
    if (rows[n].count > 0) {
      rect.row = std::min(rect.row, rows[n].first);
      row_end = std::max(row_end, rows[n].first + rows[n].count);
    }
  }
  if (column_end <= rect.column || row_end <= rect.row) {
    std::fill(out.begin(), out.end(), std::numeric_limits<float>::quiet_NaN());
    return;
  }
  rect.columns = column_end - rect.column;
  rect.rows = row_end - rect.row;
  thread_local std::vector<float> nodes;
  nodes.resize(static_cast<std::size_t>(rect.columns) * rect.rows * channels);
  map.read_block(rect, nodes);

  for (int r = 0; r < side; ++r) {
    for (int c = 0; c < side; ++c) {
      for (int channel = 0; channel < channels; ++channel) {
        double sum = 0.0;
        for (int y = 0; y < rows[r].count; ++y) {
          for (int x = 0; x < columns[c].count; ++x) {
            const std::size_t node = static_cast<std::size_t>(rows[r].first - rect.row + y) * rect.columns +
                                     (columns[c].first - rect.column + x);
            sum += axis_weight(rows[r], y, filtered) * axis_weight(columns[c], x, filtered) *
                   static_cast<double>(nodes[node * channels + channel]);
          }
        }
        const bool inside = rows[r].count > 0 && columns[c].count > 0;
        out[static_cast<std::size_t>((r * side + c) * channels + channel)] =
            inside ? static_cast<float>(sum) : std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
}

}  // namespace prairie
