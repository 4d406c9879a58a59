#include "animation/node_block.h"

#include <algorithm>
#include <cmath>

namespace prairie {

NodeRange nodes_in_box(const NodeBlock& block, glm::dvec2 low_m, glm::dvec2 high_m) {
  const auto first = [&](double from_m, double at_m) {
    return static_cast<int>(std::clamp(std::ceil((at_m - from_m) / block.spacing_m), 0.0, 1e9));
  };
  const auto last = [&](double from_m, double at_m, int count) {
    return static_cast<int>(std::clamp(std::floor((at_m - from_m) / block.spacing_m), -1.0, count - 1.0));
  };
  const glm::dvec2 from_m = block.low_m();
  return {first(from_m.x, low_m.x), last(from_m.x, high_m.x, block.columns), first(from_m.y, low_m.y),
          last(from_m.y, high_m.y, block.rows)};
}

}  // namespace prairie
