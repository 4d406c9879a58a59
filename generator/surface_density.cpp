#include "generator/surface_density.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace prairie {

NodeGrid density_per_map(const NodeGrid& per_surface_m2, const HeightField& ground) {
  if (ground.is_uniform()) return per_surface_m2;
  const bool ground_is_finer =
      per_surface_m2.is_uniform() || ground.frame().spacing_m < per_surface_m2.frame().spacing_m;
  const GridFrame frame = ground_is_finer ? ground.frame() : per_surface_m2.frame();
  std::vector<float> values(static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows));
  tbb::parallel_for(0, frame.rows, [&](int row) {
    for (int column = 0; column < frame.columns; ++column) {
      const glm::dvec2 place_m = frame.origin_m + frame.spacing_m * glm::dvec2(column, row);
      const glm::vec2 slope = ground.slope(place_m);
      values[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
             static_cast<std::size_t>(column)] =
          per_surface_m2.sample(place_m) * std::sqrt(1.0f + glm::dot(slope, slope));
    }
  });
  return NodeGrid(frame, 1, std::move(values));
}

}  // namespace prairie
