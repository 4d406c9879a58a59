#include "world/effort.h"

#include <algorithm>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr double kPerMetre = 0.5;
constexpr double kMostEffort = 1.8;
constexpr double kBladeShape = 0.6;  // a blade's area over its length times its width at the root

}  // namespace

double effort_at(const Meadow& meadow, glm::dvec2 position_m) {
  const auto factor = static_cast<double>(meadow.blade_height.sample(position_m));
  if (!(factor > 0.0)) return 1.0;
  double leaf_area = 0.0, weighted_height_m = 0.0;
  for (const PlantedSpecies& planted : meadow.species) {
    const SpeciesParams& params = planted.species.params;
    const auto density_per_m2 = static_cast<double>(planted.density_per_m2.sample(position_m));
    if (!(density_per_m2 > 0.0)) continue;  // where the map has no data, too
    const double height_m = factor * static_cast<double>(params.height_m);
    const double area = kBladeShape * density_per_m2 * height_m * static_cast<double>(params.width_m);
    leaf_area += area;
    weighted_height_m += area * height_m;
  }
  if (!(leaf_area > 0.0)) return 1.0;
  const double cover =
      1.0 - static_cast<double>(Kernels{}.falling_exponential(static_cast<float>(leaf_area)));
  return std::min(1.0 + kPerMetre * cover * weighted_height_m / leaf_area, kMostEffort);
}

}  // namespace prairie
