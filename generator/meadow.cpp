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

double tallest_blade_m(const Meadow& meadow) {
  double tallest_m = 0.0;
  for (const PlantedSpecies& species : meadow.species) {
    const SpeciesParams& params = species.species.params;
    tallest_m = std::max(tallest_m, static_cast<double>(params.height_m * (1.0f + layouts::kTallestSpread *
                                                                                       params.height_spread)));
  }
  return tallest_m * std::max(1.0, largest_value(meadow.blade_height));
}

double densest_per_m2(const PlantedSpecies& species) {
  return largest_value(species.density_per_m2);
}

}  // namespace prairie
