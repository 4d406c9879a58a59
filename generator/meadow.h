// All that planting depends on: the ground, the species with their density maps, the features that vary over
// the field (G03 §3.1), the tile grid and the seed. Plain data; everything planted is a pure function of it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/species.h"
#include "maps/height_field.h"
#include "maps/node_grid.h"

namespace prairie {

struct PlantedSpecies {
  Species species;
  NodeGrid density_per_m2;  // NaN nodes carry nothing
};

struct Meadow {
  std::uint64_t seed = 1;
  double tile_m = 4.0;
  glm::dvec2 extent_m{0.0};  // from (0, 0); where the ground repeats, nothing ends there
  bool repeats = false;
  HeightField ground;
  std::vector<PlantedSpecies> species;
  NodeGrid blade_height = NodeGrid::uniform(1.0f);  // factors
  NodeGrid bend = NodeGrid::uniform(1.0f);
  std::optional<NodeGrid> color;  // three channels, linear
  glm::vec3 soil_color{0.11f, 0.08f, 0.05f};
};

/// For each species a length that no blade of it exceeds. Reads the whole map of blade heights.
std::vector<double> longest_blades_m(const Meadow& meadow);

/// The largest of them.
double tallest_blade_m(const Meadow& meadow);

/// The mean density of a species over the field, from `samples` × `samples` places that lie evenly in it.
double mean_density_per_m2(const PlantedSpecies& species, glm::dvec2 extent_m, int samples);

/// The largest density of a species. Reads its whole map.
double densest_per_m2(const PlantedSpecies& species);

}  // namespace prairie
