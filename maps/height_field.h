// The ground: heights at nodes, between them a bicubic (Catmull-Rom) surface, so that slopes are continuous
// and neither 1 m nor 30 m data shows facets. Gaps (nodata) are filled smoothly so that the ground is defined
// everywhere, and remembered, so that nothing is planted on them.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "maps/height_range.h"
#include "maps/node_grid.h"

namespace prairie {

class HeightBounds;
class NodeMask;

class HeightField {
 public:
  /// Level ground without a border.
  HeightField();
  /// `heights_m`: one channel, metres; NaN nodes are filled (maps/nodata_fill.h). Throws BadInput if no node
  /// has data, and, where the nodes lie on disk, if they cannot be read.
  explicit HeightField(NodeGrid heights_m);

  const GridFrame& frame() const { return heights_.frame(); }
  bool is_uniform() const { return heights_.is_uniform(); }

  /// Height of the ground, metres; beyond the border the nearest border's height.
  float height_m(glm::dvec2 position_m) const;
  /// (∂z/∂x, ∂z/∂y), dimensionless; continuous inside the map. Beyond a border the ground is level across it.
  glm::vec2 slope(glm::dvec2 position_m) const;
  /// Upward unit normal of the surface.
  glm::vec3 normal(glm::dvec2 position_m) const;

  /// Heights at origin + step · (column, row), row by row from south: `out[row * columns + column]`. The same
  /// bits as `height_m`, several times as fast.
  void sample_lattice(glm::dvec2 origin_m, double step_m, int columns, int rows, std::span<float> out) const;

  /// Whether the box lies inside the map and on measured ground (no filled node contributes to the surface).
  bool has_data(glm::dvec2 min_m, glm::dvec2 max_m) const;

  /// Bounds that contain the surface over the box (conservative); for culling.
  HeightRange range(glm::dvec2 min_m, glm::dvec2 max_m) const;
  /// Lowest and highest measured node.
  HeightRange range() const;

 private:
  void take_nodes_in_memory();
  void take_nodes_on_disk();

  NodeGrid heights_;                            // without gaps
  NodeGrid measured_;                           // as read, with gaps; only where the nodes lie on disk
  std::shared_ptr<const NodeMask> gaps_;        // only where the nodes lie in memory and some are filled
  std::shared_ptr<const HeightBounds> bounds_;  // of heights_
  HeightRange measured_range_;
  bool has_gaps_ = false;
};

}  // namespace prairie
