#include "animation/wind.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <cassert>
#include <vector>

namespace prairie {

glm::vec2 wind_m_per_s(const Wind& wind, glm::dvec2 position_m, double time_s) {
  const glm::dvec2 mean = wind.mean.velocity_m_per_s(position_m, time_s);
  glm::vec2 sum(mean);
  if (wind.noise) sum += wind.noise->velocity_m_per_s(position_m, mean, wind.mean.drift_m(time_s));
  if (wind.wake) sum += wind.wake->velocity_m_per_s(position_m);
  for (const WindPrimitive& primitive : wind.primitives)
    sum += velocity_m_per_s(primitive, position_m, time_s);
  return sum;
}

WindNodes wind_nodes_around(glm::dvec2 centre_m, int side, double spacing_m) {
  assert(side > 0);
  const NodeIndex nearest = square_of(centre_m + 0.5 * spacing_m, spacing_m).south_west;
  return {{nearest.i - side / 2, nearest.j - side / 2}, side, side, spacing_m};
}

void fill_wind(const Wind& wind, const WindNodes& nodes, double time_s, std::span<glm::vec2> out_m_per_s) {
  assert(out_m_per_s.size() == nodes.size());
  const glm::dvec2 drift_m = wind.mean.drift_m(time_s);
  const glm::dvec2 low_m = nodes.low_m();

  // The nodes that each primitive covers now.
  struct Part {
    BlowingPrimitive primitive;
    NodeRange range;
  };
  std::vector<Part> parts;
  for (const WindPrimitive& primitive : wind.primitives) {
    const std::optional<BlowingPrimitive> now = blowing(primitive, time_s);
    if (!now) continue;
    const NodeRange range = nodes_in_box(nodes, now->low_m, now->high_m);
    if (!range.is_empty()) parts.push_back({*now, range});
  }

  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, nodes.rows, 8), [&](const auto& range) {
    std::vector<glm::dvec2> means(static_cast<std::size_t>(nodes.columns));
    for (int row = range.begin(); row != range.end(); ++row) {
      const std::span<glm::vec2> out =
          out_m_per_s.subspan(static_cast<std::size_t>(row) * static_cast<std::size_t>(nodes.columns),
                              static_cast<std::size_t>(nodes.columns));
      const auto place_m = [&](int column) { return low_m + glm::dvec2(column, row) * nodes.spacing_m; };
      for (int column = 0; column < nodes.columns; ++column) {
        const auto n = static_cast<std::size_t>(column);
        means[n] = wind.mean.velocity_m_per_s(place_m(column), time_s);
        out[n] = glm::vec2(means[n]);
      }
      if (wind.noise) wind.noise->add_row(place_m(0), nodes.spacing_m, means, drift_m, out);
      if (wind.wake) {
        for (int column = 0; column < nodes.columns; ++column)
          out[static_cast<std::size_t>(column)] += wind.wake->velocity_m_per_s(place_m(column));
      }
      for (const Part& part : parts) {
        if (row < part.range.first_row || row > part.range.last_row) continue;
        for (int column = part.range.first_column; column <= part.range.last_column; ++column) {
          out[static_cast<std::size_t>(column)] += velocity_m_per_s(part.primitive, place_m(column));
        }
      }
    }
  });
}

}  // namespace prairie
