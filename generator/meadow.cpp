#include "generator/meadow.h"

#include <algorithm>
#include <vector>

namespace prairie {
namespace {

// The largest value of a map, 0 where it has none. Row by row: the map may be larger than memory.
double largest_value(const NodeGrid& map) {
  if (map.is_uniform()) return static_cast<double>(map.sample({0.0, 0.0}));
  float largest = 0.0f;
  std::vector<float> row(static_cast<std::size_t>(map.frame().columns));
  for (int j = 0; j < map.frame().rows; ++j) {
    map.read_block({0, j, map.frame().columns, 1}, row);
    for (const float value : row) largest = std::max(largest, value);  // unchanged by NaN
  }
  return static_cast<double>(largest);
}

}  // namespace

std::vector<double> longest_blades_m(const Meadow& meadow) {
  const double factor = std::max(1.0, largest_value(meadow.blade_height));
  std::vector<double> longest_m;
  for (const PlantedSpecies& species : meadow.species) {
    const SpeciesParams& params = species.species.params;
    longest_m.push_back(factor * static_cast<double>(params.height_m * (1.0f + layouts::kTallestSpread *
                                                                                   params.height_spread)));
  }
  return longest_m;
}

double tallest_blade_m(const Meadow& meadow) {
  const std::vector<double> longest_m = longest_blades_m(meadow);
  return longest_m.empty() ? 0.0 : *std::max_element(longest_m.begin(), longest_m.end());
}

double mean_density_per_m2(const PlantedSpecies& species, glm::dvec2 extent_m, int samples) {
  double sum = 0.0;
  for (int n = 0; n < samples * samples; ++n) {
    const glm::dvec2 share = (glm::dvec2(n % samples, n / samples) + 0.5) / static_cast<double>(samples);
    const float density_per_m2 = species.density_per_m2.sample(share * extent_m);
    if (density_per_m2 > 0.0f) sum += static_cast<double>(density_per_m2);  // false for NaN
  }
  return sum / (samples * samples);
}

double densest_per_m2(const PlantedSpecies& species) {
  return largest_value(species.density_per_m2);
}

}  // namespace prairie
