#include "lod/sward/field_look.h"

#include <algorithm>

#include "lod/sward/flat_map.h"

namespace prairie {
namespace {

constexpr int kDensitySamples = 64;  // along a side of the field
// Blades bend, so that a sward stands a little lower than they are long.
constexpr double kStandingShare = 0.8;

}  // namespace

FieldMix field_mix(const Meadow& meadow) {
  FieldMix mix;
  double sum = 0.0;
  for (const PlantedSpecies& species : meadow.species) {
    mix.species.push_back(species.species.params);
    mix.species.back().densest_per_m2 = static_cast<float>(std::max(densest_per_m2(species), 1e-3));
    mix.densities_per_m2.push_back(mean_density_per_m2(species, meadow.extent_m, kDensitySamples));
    sum += mix.densities_per_m2.back();
  }
  if (sum <= 0.0) std::ranges::fill(mix.densities_per_m2, 1.0);
  return mix;
}

std::vector<SwardLayer> layers_of(const FieldMix& mix) {
  std::vector<SwardLayer> layers;
  for (std::size_t s = 0; s < mix.species.size(); ++s)
    layers.push_back({&mix.species[s], mix.densities_per_m2[s]});
  return layers;
}

FieldLook field_look(const FieldMix& mix, const SwardResponse& response) {
  FieldLook look;
  double blades = 0.0, leaf_area = 0.0, seen_area = 0.0, height_m = 0.0, width_m = 0.0;
  glm::dvec3 albedo(0.0);
  for (std::size_t s = 0; s < mix.species.size(); ++s) {
    const SwardResponse::Layer& layer = response.layers[s];
    const SpeciesParams& species = mix.species[s];
    const double seen_m2 = layer.blade_area_m2 * static_cast<double>(layer.projected.back());
    look.blade_area_from_above_m2.push_back(seen_m2);
    const double density = mix.densities_per_m2[s];
    blades += density;
    leaf_area += density * layer.blade_area_m2;
    seen_area += density * seen_m2;
    height_m += density * layer.blade_area_m2 * kStandingShare * static_cast<double>(species.height_m);
    width_m += density * layer.blade_area_m2 * static_cast<double>(species.width_m);
    albedo += density * seen_m2 * glm::dvec3(mean_albedo(species));
  }
  look.mean_albedo = glm::vec3(albedo / seen_area);
  look.projected_from_above = seen_area / leaf_area;
  look.density_per_leaf_area = blades / leaf_area;
  look.height_m = height_m / leaf_area;
  look.blade_width_m = width_m / leaf_area;
  return look;
}

}  // namespace prairie
