#include "maps/node_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "maps/node_index.h"

namespace prairie {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
// Positions are sums and products of doubles; a tile that ends on the last node must not miss it by a
// rounding error.
constexpr double kBorderTolerance = 1e-6;
constexpr double kMaxNodeCoordinate = 1e9;  // keeps far positions of repeated grids inside int

bool holds_nan(std::span<const float> values) {
  return std::any_of(values.begin(), values.end(), [](float v) { return std::isnan(v); });
}

/// The node below a coordinate, and how far the coordinate lies towards the next one, in [0, 1).
struct Step {
  int node = 0;
  double fraction = 0.0;
};

/// Where a coordinate (in nodes) lies on an axis of `count` nodes; false beyond its border.
bool locate(double coordinate, int count, bool repeats, Step* step) {
  if (repeats) {
    coordinate = std::fmod(coordinate, static_cast<double>(count));
    if (coordinate < 0.0) coordinate += count;
  } else {
    const double last = count - 1;
    // Written so that NaN is beyond the border.
    if (!(coordinate >= -kBorderTolerance && coordinate <= last + kBorderTolerance)) return false;
    coordinate = std::clamp(coordinate, 0.0, last);
  }
  if (!std::isfinite(coordinate)) return false;
  const double below = std::floor(coordinate);
  *step = {static_cast<int>(below), coordinate - below};
  return true;
}

/// The nodes that linear interpolation needs between two coordinates of one axis; false beyond the border.
bool span_between(double low, double high, int count, bool repeats, IndexSpan* span) {
  if (!(low <= high)) return false;
  if (repeats) {
    if (!(std::abs(low) < kMaxNodeCoordinate && std::abs(high) < kMaxNodeCoordinate)) return false;
  } else if (low < -kBorderTolerance || high > count - 1 + kBorderTolerance) {
    return false;
  }
  const double first = std::floor(low + kBorderTolerance);
  const double last = std::max(first, std::ceil(high - kBorderTolerance));
  *span = {static_cast<int>(first), static_cast<int>(last - first) + 1};
  return true;
}

bool contains(const GridFrame& frame, const NodeRect& rect) {
  return rect.column >= 0 && rect.row >= 0 && rect.columns <= frame.columns && rect.rows <= frame.rows &&
         rect.column <= frame.columns - rect.columns && rect.row <= frame.rows - rect.rows;
}

NodeRect nearest_inside(const GridFrame& frame, const NodeRect& rect) {
  const IndexSpan x = inside_span({rect.column, rect.columns}, frame.columns, frame.repeats);
  const IndexSpan y = inside_span({rect.row, rect.rows}, frame.rows, frame.repeats);
  return {x.first, y.first, x.count, y.count};
}

}  // namespace

NodeGrid::NodeGrid(GridFrame frame, int channels, std::vector<float> values)
    : frame_(frame), channels_(channels), may_have_gaps_(holds_nan(values)), values_(std::move(values)) {
  assert(frame.columns > 0 && frame.rows > 0 && frame.spacing_m > 0.0 && channels > 0);
  assert(values_.size() == static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows) *
                               static_cast<std::size_t>(channels));
}

NodeGrid::NodeGrid(GridFrame frame, int channels, std::shared_ptr<const NodeSource> source,
                   bool may_have_gaps)
    : frame_(frame), channels_(channels), may_have_gaps_(may_have_gaps), source_(std::move(source)) {
  assert(frame.columns > 0 && frame.rows > 0 && frame.spacing_m > 0.0 && channels > 0);
  assert(source_ != nullptr);
}

NodeGrid NodeGrid::uniform(float value) {
  NodeGrid grid;
  grid.frame_ = {.columns = 1, .rows = 1, .spacing_m = 1.0, .origin_m = glm::dvec2(0.0), .repeats = true};
  grid.uniform_ = true;
  grid.uniform_value_ = value;
  return grid;
}

void NodeGrid::read_block(const NodeRect& rect, std::span<float> out) const {
  assert(rect.columns >= 0 && rect.rows >= 0);
  const std::size_t channels = static_cast<std::size_t>(channels_);
  const std::size_t row_values = static_cast<std::size_t>(rect.columns) * channels;
  assert(out.size() >= row_values * static_cast<std::size_t>(rect.rows));
  if (row_values == 0 || rect.rows == 0) return;
  if (uniform_) {
    std::fill_n(out.begin(), row_values * static_cast<std::size_t>(rect.rows), uniform_value_);
    return;
  }
  assert(frame_.columns > 0 && frame_.rows > 0);

  if (source_ == nullptr) {
    copy_block(values_, {0, 0, frame_.columns, frame_.rows}, rect, out);
    return;
  }
  if (contains(frame_, rect)) {
    source_->read(rect, out);
    return;
  }
  // A source is asked for what lies inside the grid at once; row by row it would fetch and drop pages again
  // and again.
  const NodeRect inside = nearest_inside(frame_, rect);
  std::vector<float> nodes(static_cast<std::size_t>(inside.columns) * static_cast<std::size_t>(inside.rows) *
                           channels);
  source_->read(inside, nodes);
  copy_block(nodes, inside, rect, out);
}

void NodeGrid::copy_block(std::span<const float> nodes, const NodeRect& have, const NodeRect& rect,
                          std::span<float> out) const {
  const std::size_t channels = static_cast<std::size_t>(channels_);
  for (int j = 0; j < rect.rows; ++j) {
    const int row = border_index(rect.row + j, frame_.rows, frame_.repeats) - have.row;
    for (int i = 0; i < rect.columns;) {
      const int column = border_index(rect.column + i, frame_.columns, frame_.repeats);
      // Runs of neighbours are copied at once; beyond a border that does not repeat every node is the same
      // one.
      const bool beyond = column != rect.column + i && !frame_.repeats;
      const int length = beyond ? 1 : std::min(rect.columns - i, frame_.columns - column);
      const std::size_t from = (static_cast<std::size_t>(row) * static_cast<std::size_t>(have.columns) +
                                static_cast<std::size_t>(column - have.column)) *
                               channels;
      const std::size_t to = (static_cast<std::size_t>(j) * static_cast<std::size_t>(rect.columns) +
                              static_cast<std::size_t>(i)) *
                             channels;
      std::memcpy(out.data() + to, nodes.data() + from,
                  static_cast<std::size_t>(length) * channels * sizeof(float));
      i += length;
    }
  }
}

float NodeGrid::sample(glm::dvec2 position_m, int channel) const {
  assert(channel >= 0 && channel < channels_);
  if (uniform_) return uniform_value_;
  const glm::dvec2 coordinate = (position_m - frame_.origin_m) / frame_.spacing_m;
  Step x, y;
  if (!locate(coordinate.x, frame_.columns, frame_.repeats, &x)) return kNaN;
  if (!locate(coordinate.y, frame_.rows, frame_.repeats, &y)) return kNaN;

  std::array<float, 4> corner;
  if (source_ == nullptr) {
    const auto value = [&](int column, int row) {
      const std::size_t node = static_cast<std::size_t>(border_index(row, frame_.rows, frame_.repeats)) *
                                   static_cast<std::size_t>(frame_.columns) +
                               static_cast<std::size_t>(border_index(column, frame_.columns, frame_.repeats));
      return values_[node * static_cast<std::size_t>(channels_) + static_cast<std::size_t>(channel)];
    };
    corner = {value(x.node, y.node), value(x.node + 1, y.node), value(x.node, y.node + 1),
              value(x.node + 1, y.node + 1)};
  } else {
    std::vector<float> block(4 * static_cast<std::size_t>(channels_));
    read_block({x.node, y.node, 2, 2}, block);
    for (std::size_t k = 0; k < 4; ++k) {
      corner[k] = block[k * static_cast<std::size_t>(channels_) + static_cast<std::size_t>(channel)];
    }
  }

  // A corner of weight zero does not contribute, even if it has no data.
  const auto mixed = [](double low, double high, double t) {
    return t == 0.0 ? low : low + (high - low) * t;
  };
  const double south = mixed(static_cast<double>(corner[0]), static_cast<double>(corner[1]), x.fraction);
  const double north = mixed(static_cast<double>(corner[2]), static_cast<double>(corner[3]), x.fraction);
  return static_cast<float>(mixed(south, north, y.fraction));
}

bool NodeGrid::has_data(glm::dvec2 min_m, glm::dvec2 max_m) const {
  if (uniform_) return true;
  const glm::dvec2 low = (min_m - frame_.origin_m) / frame_.spacing_m;
  const glm::dvec2 high = (max_m - frame_.origin_m) / frame_.spacing_m;
  IndexSpan x, y;
  if (!span_between(low.x, high.x, frame_.columns, frame_.repeats, &x)) return false;
  if (!span_between(low.y, high.y, frame_.rows, frame_.repeats, &y)) return false;
  if (!may_have_gaps_) return true;

  // One row at a time: a box may be as large as a map that does not fit into memory.
  const int columns = frame_.repeats ? std::min(x.count, frame_.columns) : x.count;
  const int rows = frame_.repeats ? std::min(y.count, frame_.rows) : y.count;
  std::vector<float> row(static_cast<std::size_t>(columns) * static_cast<std::size_t>(channels_));
  for (int j = 0; j < rows; ++j) {
    read_block({x.first, y.first + j, columns, 1}, row);
    if (holds_nan(row)) return false;
  }
  return true;
}

}  // namespace prairie
