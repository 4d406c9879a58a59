// Rectangular blocks of a lattice's nodes (animation/node_field.h), for fields that are functions of place
// and time: what covers a part of the plane only is evaluated at the nodes of its box.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "animation/node_field.h"

namespace prairie {

/// Node (i, j) lies at (i, j) · spacing_m.
struct NodeBlock {
  NodeIndex south_west;
  int columns = 0;
  int rows = 0;
  double spacing_m = 1.0;

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  glm::dvec2 low_m() const { return glm::dvec2(south_west.i, south_west.j) * spacing_m; }
};

/// Columns and rows of a block, the last ones included; none where a first one comes after the last.
struct NodeRange {
  int first_column = 0, last_column = -1, first_row = 0, last_row = -1;

  bool is_empty() const { return first_column > last_column || first_row > last_row; }
  std::size_t size() const {
    return is_empty() ? 0
                      : static_cast<std::size_t>(last_column - first_column + 1) *
                            static_cast<std::size_t>(last_row - first_row + 1);
  }
};

/// The nodes of a block that lie in a box of the ground, borders included.
NodeRange nodes_in_box(const NodeBlock& block, glm::dvec2 low_m, glm::dvec2 high_m);

}  // namespace prairie
