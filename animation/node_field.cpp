#include "animation/node_field.h"

#include <cmath>

namespace prairie {
namespace {

int floored_division(int value) {
  const int quotient = value / kPageNodes;
  return quotient * kPageNodes > value ? quotient - 1 : quotient;
}

}  // namespace

PageIndex page_of(NodeIndex node) {
  return {.j = floored_division(node.j), .i = floored_division(node.i)};
}

std::size_t slot_of(NodeIndex node) {
  const NodeIndex corner = page_of(node).south_west();
  return static_cast<std::size_t>((node.j - corner.j) * kPageNodes + (node.i - corner.i));
}

NodeSquare square_of(glm::dvec2 position_m, double spacing_m) {
  const double x = position_m.x / spacing_m, y = position_m.y / spacing_m;
  const double column = std::floor(x), row = std::floor(y);
  assert(std::abs(column) < 2e9 && std::abs(row) < 2e9);
  return {{static_cast<int>(column), static_cast<int>(row)},
          static_cast<float>(x - column),
          static_cast<float>(y - row)};
}

}  // namespace prairie
