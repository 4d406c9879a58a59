#include "maps/height_field.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "files/error.h"
#include "maps/catmull_rom.h"
#include "maps/filled_heights.h"
#include "maps/ground_survey.h"
#include "maps/height_bounds.h"
#include "maps/nodata_fill.h"
#include "maps/node_index.h"
#include "maps/node_mask.h"

namespace prairie {
namespace {

constexpr double kMaxNodeCoordinate = 1e9;  // keeps positions, however far, inside int
constexpr double kNodeTolerance = 1e-6;     // of the spacing; see NodeGrid::has_data
constexpr std::size_t kMostNodesFilledAtOnce = 1 << 22;
constexpr int kBandRows = 64;  // lattice rows worked on at once; bounds the scratch memory

using Weights = std::array<double, 4>;

/// Where a coordinate lies on one axis: the second of the four nodes that carry it, and how far it is beyond
/// that.
struct Place {
  int node = 0;
  double t = 0.0;
  bool inside = true;
};

Place locate(double coordinate, int count, bool repeats) {
  if (!(std::abs(coordinate) < kMaxNodeCoordinate)) coordinate = coordinate > 0.0 ? kMaxNodeCoordinate : 0.0;
  bool inside = true;
  if (!repeats) {
    const double last = count - 1;
    inside = coordinate >= 0.0 && coordinate <= last;
    coordinate = std::clamp(coordinate, 0.0, last);
  }
  const double below = std::floor(coordinate);
  return {static_cast<int>(below), coordinate - below, inside};
}

/// The 4 × 4 nodes around a place, as pointers to rows: into the grid where they lie inside it, else to a
/// copy.
struct Patch {
  std::array<const float*, 4> rows;
  std::array<float, 16> copy;
};

void fetch(const NodeGrid& grid, const Place& x, const Place& y, Patch* patch) {
  const GridFrame& frame = grid.frame();
  const std::span<const float> values = grid.values();
  const bool inside = x.node >= 1 && x.node + 2 < frame.columns && y.node >= 1 && y.node + 2 < frame.rows;
  if (inside && !values.empty()) {
    const float* first = values.data() +
                         static_cast<std::size_t>(y.node - 1) * static_cast<std::size_t>(frame.columns) +
                         (x.node - 1);
    for (float const*& row : patch->rows) {
      row = first;
      first += frame.columns;
    }
    return;
  }
  grid.read_block({x.node - 1, y.node - 1, 4, 4}, patch->copy);
  for (std::size_t j = 0; j < 4; ++j) patch->rows[j] = patch->copy.data() + 4 * j;
}

double across(const float* nodes, const Weights& w) {
  return (w[0] * static_cast<double>(nodes[0]) + w[1] * static_cast<double>(nodes[1])) +
         (w[2] * static_cast<double>(nodes[2]) + w[3] * static_cast<double>(nodes[3]));
}

double combined(const Weights& w, double a, double b, double c, double d) {
  return (w[0] * a + w[1] * b) + (w[2] * c + w[3] * d);
}

double surface(const Patch& patch, const Weights& x, const Weights& y) {
  return combined(y, across(patch.rows[0], x), across(patch.rows[1], x), across(patch.rows[2], x),
                  across(patch.rows[3], x));
}

/// The nodes that carry the surface between two coordinates of one axis.
IndexSpan carriers(double low, double high, int count, bool repeats) {
  const int first = locate(low, count, repeats).node - 1;
  const int last = locate(high, count, repeats).node + 2;
  return inside_span({first, last - first + 1}, count, repeats);
}

/// As `carriers`, but leaving out nodes whose weight is zero because the box ends on a node; false beyond the
/// border.
bool needed_nodes(double low, double high, int count, bool repeats, IndexSpan* span) {
  if (!(low <= high)) return false;
  if (!repeats && !(low >= -kNodeTolerance && high <= count - 1 + kNodeTolerance)) return false;
  if (!(std::abs(low) < kMaxNodeCoordinate && std::abs(high) < kMaxNodeCoordinate)) return false;
  int first = static_cast<int>(std::floor(low + kNodeTolerance));
  int last = std::max(first, static_cast<int>(std::ceil(high - kNodeTolerance)));
  if (last > first) --first, ++last;
  *span = inside_span({first, last - first + 1}, count, repeats);
  return true;
}

struct NodeCensus {
  HeightRange measured{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  bool has_gaps = false;
};

NodeCensus census_of(std::span<const float> nodes) {
  const auto of_range = [&](const tbb::blocked_range<std::size_t>& range, NodeCensus census) {
    for (std::size_t k = range.begin(); k != range.end(); ++k) {
      if (std::isnan(nodes[k])) {
        census.has_gaps = true;
      } else {
        census.measured = united(census.measured, {nodes[k], nodes[k]});
      }
    }
    return census;
  };
  const auto of_both = [](const NodeCensus& a, const NodeCensus& b) {
    return NodeCensus{united(a.measured, b.measured), a.has_gaps || b.has_gaps};
  };
  constexpr std::size_t kWorthAThread = 1 << 16;
  return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, nodes.size(), kWorthAThread), NodeCensus{},
                              of_range, of_both);
}

}  // namespace

HeightField::HeightField() : heights_(NodeGrid::uniform(0.0f)) {}

HeightField::HeightField(NodeGrid heights_m) : heights_(std::move(heights_m)) {
  assert(heights_.channels() == 1);
  if (heights_.is_uniform()) {
    const float height_m = heights_.sample(glm::dvec2(0.0));
    measured_range_ = {height_m, height_m};
  } else if (heights_.in_memory()) {
    take_nodes_in_memory();
  } else {
    take_nodes_on_disk();
  }
}

void HeightField::take_nodes_in_memory() {
  const GridFrame& frame = heights_.frame();
  const std::span<const float> nodes = std::as_const(heights_).values();
  const NodeCensus census = census_of(nodes);
  measured_range_ = census.measured;
  has_gaps_ = census.has_gaps;
  if (measured_range_.min_m > measured_range_.max_m) {
    throw BadInput("", "", "a height map without data", "at least one node with a height");
  }
  if (has_gaps_) {
    gaps_ = std::make_shared<NodeMask>(frame.columns, frame.rows, nodes);
    // The gap that crosses a border of repeated ground is filled as one.
    if (frame.repeats || nodes.size() <= kMostNodesFilledAtOnce) {
      fill_nodata(frame.columns, frame.rows, frame.repeats, heights_.values());
    } else {
      fill_page_by_page(frame, *gaps_, heights_.values());
    }
  }
  bounds_ = std::make_shared<HeightBounds>(HeightBounds::of(heights_));
}

void HeightField::take_nodes_on_disk() {
  GroundSurvey survey = survey_ground(heights_);
  measured_range_ = survey.measured_m;
  has_gaps_ = survey.has_gaps;
  bounds_ = std::make_shared<HeightBounds>(std::move(survey.bounds));
  if (has_gaps_) {
    measured_ = heights_;
    heights_ = filled_heights(measured_, std::move(survey.overview));
  }
}

float HeightField::height_m(glm::dvec2 position_m) const {
  const GridFrame& frame = heights_.frame();
  const glm::dvec2 coordinate = (position_m - frame.origin_m) / frame.spacing_m;
  const Place x = locate(coordinate.x, frame.columns, frame.repeats);
  const Place y = locate(coordinate.y, frame.rows, frame.repeats);
  Patch patch;
  fetch(heights_, x, y, &patch);
  return static_cast<float>(surface(patch, catmull_rom(x.t), catmull_rom(y.t)));
}

glm::vec2 HeightField::slope(glm::dvec2 position_m) const {
  const GridFrame& frame = heights_.frame();
  const glm::dvec2 coordinate = (position_m - frame.origin_m) / frame.spacing_m;
  const Place x = locate(coordinate.x, frame.columns, frame.repeats);
  const Place y = locate(coordinate.y, frame.rows, frame.repeats);
  Patch patch;
  fetch(heights_, x, y, &patch);
  const double east = surface(patch, catmull_rom_slope(x.t), catmull_rom(y.t));
  const double north = surface(patch, catmull_rom(x.t), catmull_rom_slope(y.t));
  return {x.inside ? static_cast<float>(east / frame.spacing_m) : 0.0f,
          y.inside ? static_cast<float>(north / frame.spacing_m) : 0.0f};
}

glm::vec3 HeightField::normal(glm::dvec2 position_m) const {
  const glm::vec2 s = slope(position_m);
  const float scale = 1.0f / std::sqrt(s.x * s.x + s.y * s.y + 1.0f);
  return {-s.x * scale, -s.y * scale, scale};
}

void HeightField::sample_lattice(glm::dvec2 origin_m, double step_m, int columns, int rows,
                                 std::span<float> out) const {
  assert(step_m > 0.0 && columns >= 0 && rows >= 0);
  assert(out.size() >= static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  if (columns == 0 || rows == 0) return;
  const GridFrame& frame = heights_.frame();
  const std::size_t width = static_cast<std::size_t>(columns);
  if (is_uniform()) {
    std::fill_n(out.begin(), width * static_cast<std::size_t>(rows), measured_range_.min_m);
    return;
  }
  // A lattice much coarser than the nodes would fetch mostly nodes that it does not need.
  if (step_m > 4.0 * frame.spacing_m) {
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        out[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i)] =
            height_m(origin_m + step_m * glm::dvec2(i, j));
      }
    }
    return;
  }

  std::vector<Place> x(width);
  std::vector<Weights> weights(width);
  for (std::size_t i = 0; i < width; ++i) {
    const double position_m = origin_m.x + step_m * static_cast<double>(i);
    x[i] = locate((position_m - frame.origin_m.x) / frame.spacing_m, frame.columns, frame.repeats);
    weights[i] = catmull_rom(x[i].t);
  }
  const int first_column = x.front().node - 1;
  const int node_columns = x.back().node + 3 - first_column;

  std::vector<float> nodes;
  std::vector<double> strips;  // every node row of the band, already interpolated along x
  std::array<Place, kBandRows> y;
  for (int first = 0; first < rows; first += kBandRows) {
    const int band = std::min(kBandRows, rows - first);
    for (int j = 0; j < band; ++j) {
      const double position_m = origin_m.y + step_m * static_cast<double>(first + j);
      y[static_cast<std::size_t>(j)] =
          locate((position_m - frame.origin_m.y) / frame.spacing_m, frame.rows, frame.repeats);
    }
    const int first_row = y.front().node - 1;
    const int node_rows = y[static_cast<std::size_t>(band - 1)].node + 3 - first_row;
    nodes.resize(static_cast<std::size_t>(node_columns) * static_cast<std::size_t>(node_rows));
    heights_.read_block({first_column, first_row, node_columns, node_rows}, nodes);

    strips.resize(static_cast<std::size_t>(node_rows) * width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(node_rows); ++row) {
      const float* node_row = nodes.data() + row * static_cast<std::size_t>(node_columns);
      double* strip = strips.data() + row * width;
      for (std::size_t i = 0; i < width; ++i) {
        strip[i] = across(node_row + (x[i].node - 1 - first_column), weights[i]);
      }
    }
    for (int j = 0; j < band; ++j) {
      const Place& place = y[static_cast<std::size_t>(j)];
      const Weights w = catmull_rom(place.t);
      const double* strip = strips.data() + static_cast<std::size_t>(place.node - 1 - first_row) * width;
      float* row_out = out.data() + static_cast<std::size_t>(first + j) * width;
      for (std::size_t i = 0; i < width; ++i) {
        row_out[i] = static_cast<float>(
            combined(w, strip[i], strip[i + width], strip[i + 2 * width], strip[i + 3 * width]));
      }
    }
  }
}

bool HeightField::has_data(glm::dvec2 min_m, glm::dvec2 max_m) const {
  if (is_uniform()) return true;
  const GridFrame& frame = heights_.frame();
  const glm::dvec2 low = (min_m - frame.origin_m) / frame.spacing_m;
  const glm::dvec2 high = (max_m - frame.origin_m) / frame.spacing_m;
  IndexSpan x, y;
  if (!needed_nodes(low.x, high.x, frame.columns, frame.repeats, &x)) return false;
  if (!needed_nodes(low.y, high.y, frame.rows, frame.repeats, &y)) return false;
  if (!has_gaps_) return true;
  if (gaps_ != nullptr) return !gaps_->any({x.first, y.first, x.count, y.count});
  const glm::dvec2 first_m = frame.origin_m + frame.spacing_m * glm::dvec2(x.first, y.first);
  return measured_.has_data(first_m, first_m + frame.spacing_m * glm::dvec2(x.count - 1, y.count - 1));
}

HeightRange HeightField::range(glm::dvec2 min_m, glm::dvec2 max_m) const {
  assert(min_m.x <= max_m.x && min_m.y <= max_m.y);
  if (is_uniform()) return measured_range_;
  const GridFrame& frame = heights_.frame();
  const glm::dvec2 low = (min_m - frame.origin_m) / frame.spacing_m;
  const glm::dvec2 high = (max_m - frame.origin_m) / frame.spacing_m;
  const IndexSpan x = carriers(low.x, high.x, frame.columns, frame.repeats);
  const IndexSpan y = carriers(low.y, high.y, frame.rows, frame.repeats);
  const HeightRange nodes = bounds_->over({x.first, y.first, x.count, y.count});
  const float middle_m = 0.5f * (nodes.min_m + nodes.max_m);
  const float reach_m = kCatmullRomOvershoot * 0.5f * (nodes.max_m - nodes.min_m);
  // Outwards by one step of the type, for the rounding of these lines.
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {std::nextafter(middle_m - reach_m, -kInfinity), std::nextafter(middle_m + reach_m, kInfinity)};
}

HeightRange HeightField::range() const {
  return measured_range_;
}

}  // namespace prairie
