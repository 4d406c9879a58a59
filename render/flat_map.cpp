#include "render/flat_map.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr int kMostTexels = 2048;  // along a side
constexpr double kCoarsestTexelM = 4.0;
// The leaf area that a blade shows from above: its profile fills two thirds of length × width, and it stands
// steeply.
constexpr double kProjectedShare = 0.67 * 0.6;
// Where along a blade its mean visible colour is found: the upper part hides the lower.
constexpr float kVisibleTip = 0.62f;

double texel_side_m(const Meadow& meadow) {
  double finest_m = kCoarsestTexelM;
  for (const PlantedSpecies& species : meadow.species) {
    if (!species.density_per_m2.is_uniform())
      finest_m = std::min(finest_m, species.density_per_m2.frame().spacing_m);
  }
  const double longest_m = std::max(meadow.extent_m.x, meadow.extent_m.y);
  return std::max(finest_m, longest_m / (kMostTexels - 1));
}

std::uint8_t byte_of(double share) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

double srgb_from_linear(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

glm::vec3 mean_albedo(const SpeciesParams& species) {
  Kernels kernels;
  return kernels.mixed(kernels.root_albedo(species, 0.0f, species.dry_share),
                       kernels.tip_albedo(species, 0.0f, species.dry_share), kVisibleTip);
}

float value_at(const NodeGrid& map, glm::dvec2 place_m, int channel, float missing) {
  const float value = map.sample(place_m, map.channels() > 1 ? channel : 0);
  return std::isfinite(value) ? value : missing;
}

void fill_texel(const Meadow& meadow, const std::vector<glm::vec3>& albedos, glm::dvec2 place_m,
                std::uint8_t* texel) {
  glm::dvec3 color(0.0);
  double area = 0.0;
  for (std::size_t s = 0; s < meadow.species.size(); ++s) {
    const double density = static_cast<double>(value_at(meadow.species[s].density_per_m2, place_m, 0, 0.0f));
    const double hidden =
        -std::log1p(-std::min(cover_from_above(meadow.species[s].species.params, density), 0.999999));
    color += hidden * glm::dvec3(albedos[s]);
    area += hidden;
  }
  area *= static_cast<double>(value_at(meadow.blade_height, place_m, 0, 1.0f));
  if (!meadow.ground.has_data(place_m, place_m)) area = 0.0;
  for (int channel = 0; channel < 3; ++channel) {
    const double tint =
        meadow.color ? static_cast<double>(value_at(*meadow.color, place_m, channel, 1.0f)) : 1.0;
    const double albedo =
        area > 0.0 ? color[channel] / std::max(area, 1e-9) : static_cast<double>(albedos[0][channel]);
    texel[channel] = byte_of(srgb_from_linear(tint * albedo));
  }
  texel[3] = byte_of(1.0 - std::exp(-area));
}

}  // namespace

double cover_from_above(const SpeciesParams& species, double density_per_m2) {
  const double blade_m2 = static_cast<double>(species.height_m) * static_cast<double>(species.width_m);
  return 1.0 - std::exp(-kProjectedShare * blade_m2 * density_per_m2);
}

FlatMap make_flat_map(const Meadow& meadow) {
  FlatMap map;
  map.texel_m = texel_side_m(meadow);
  const int extra = meadow.repeats ? 0 : 1;
  map.columns = std::max(1, static_cast<int>(std::lround(meadow.extent_m.x / map.texel_m)) + extra);
  map.rows = std::max(1, static_cast<int>(std::lround(meadow.extent_m.y / map.texel_m)) + extra);
  map.srgb_and_cover.resize(4 * static_cast<std::size_t>(map.columns) * map.rows);
  std::vector<glm::vec3> albedos;
  for (const PlantedSpecies& species : meadow.species) albedos.push_back(mean_albedo(species.species.params));
  oneapi::tbb::parallel_for(0, map.rows, [&](int row) {
    for (int column = 0; column < map.columns; ++column) {
      const glm::dvec2 place_m = glm::min(map.texel_m * glm::dvec2(column, row), meadow.extent_m);
      fill_texel(meadow, albedos, place_m,
                 &map.srgb_and_cover[4 * (static_cast<std::size_t>(row) * map.columns + column)]);
    }
  });
  return map;
}

}  // namespace prairie
