#include "world/placed_map.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace prairie {
namespace {

// Nodes on disk cannot be moved, only read through a grid that lies where the scene wants it.
class NodesOfGrid : public NodeSource {
 public:
  explicit NodesOfGrid(NodeGrid grid) : grid_(std::move(grid)) {}
  void read(const NodeRect& rect, std::span<float> out) const override { grid_.read_block(rect, out); }

 private:
  NodeGrid grid_;
};

}  // namespace

glm::dvec2 origin_in_scene_m(const GeoReference& map, const GeoReference& reference) {
  const glm::dvec2 origin_m{map.west_m - reference.west_m, map.south_m - reference.south_m};
  // Coordinates of some million metres leave rounding errors of a nanometre; grids that coincide shall do so
  // exactly.
  const double close_m = 1e-6 * map.pixel_size_m;
  const auto snapped = [close_m](double value) { return std::abs(value) < close_m ? 0.0 : value; };
  return {snapped(origin_m.x), snapped(origin_m.y)};
}

NodeGrid placed_at(NodeGrid grid, glm::dvec2 origin_m) {
  GridFrame frame = grid.frame();
  if (grid.is_uniform() || frame.origin_m == origin_m) return grid;
  frame.origin_m = origin_m;
  const int channels = grid.channels();
  const bool may_have_gaps = grid.may_have_gaps();
  if (grid.in_memory()) {
    const std::span<const float> nodes = std::as_const(grid).values();
    return NodeGrid(frame, channels, std::vector<float>(nodes.begin(), nodes.end()));
  }
  return NodeGrid(frame, channels, std::make_shared<NodesOfGrid>(std::move(grid)), may_have_gaps);
}

double covered_share(const GridFrame& frame, glm::dvec2 extent_m) {
  if (frame.repeats) return 1.0;
  const double half_m = 0.5 * frame.spacing_m;
  const glm::dvec2 far_m = frame.far_corner_m();
  const auto shared = [half_m](double first, double last, double extent) {
    return std::clamp((std::min(last + half_m, extent) - std::max(first - half_m, 0.0)) / extent, 0.0, 1.0);
  };
  return shared(frame.origin_m.x, far_m.x, extent_m.x) * shared(frame.origin_m.y, far_m.y, extent_m.y);
}

}  // namespace prairie
