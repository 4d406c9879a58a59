// The ground: heights at nodes, between them a bicubic (Catmull-Rom) surface, so that slopes are continuous and neither
// 1 m nor 30 m data shows facets. Gaps (nodata) are filled smoothly so that the ground is defined everywhere, and
// remembered, so that nothing is planted on them.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "maps/node_grid.h"

namespace prairie {

struct HeightRange {
  float min_m = 0.0f;
  float max_m = 0.0f;
};

class HeightField {
 public:
  /// Level ground without a border.
  HeightField();
  /// `heights_m`: one channel, metres; NaN nodes are filled (maps/nodata_fill.h). Throws BadInput if no node has data.
  explicit HeightField(NodeGrid heights_m);

  const GridFrame& frame() const { return heights_.frame(); }
  bool is_uniform() const { return heights_.is_uniform(); }

  /// Height of the ground, metres; beyond the border the nearest border's height.
  float height_m(glm::dvec2 position_m) const;
  /// (∂z/∂x, ∂z/∂y), dimensionless; continuous.
  glm::vec2 slope(glm::dvec2 position_m) const;
  /// Upward unit normal of the surface.
  glm::vec3 normal(glm::dvec2 position_m) const;

  /// Heights at origin + step · (column, row), row by row from south: `out[row * columns + column]`.
  void sample_lattice(glm::dvec2 origin_m, double step_m, int columns, int rows, std::span<float> out) const;

  /// Whether the box lies inside the map and on measured ground (no filled node contributes).
  bool has_data(glm::dvec2 min_m, glm::dvec2 max_m) const;

  /// Bounds that contain the surface over the box (conservative); for culling.
  HeightRange range(glm::dvec2 min_m, glm::dvec2 max_m) const;
  /// Lowest and highest measured node.
  HeightRange range() const;

 private:
  struct Bounds;  // min-max pyramid over the nodes
  NodeGrid heights_;                       // filled
  NodeGrid measured_;                      // as read: NaN where filled; shares nothing when there are no gaps
  bool has_gaps_ = false;
  std::shared_ptr<const Bounds> bounds_;
  HeightRange measured_range_;
};

}  // namespace prairie
