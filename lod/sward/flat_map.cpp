#include "lod/sward/flat_map.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr int kMostTexels = 2048;  // along a side
constexpr double kCoarsestTexelM = 4.0;
constexpr int kMostSamples = 8;  // along a texel's side, where maps are finer than texels
// Where along a blade its mean visible colour is found: the upper part hides the lower.
constexpr float kVisibleTip = 0.62f;

/// Of all maps; infinite where none has nodes.
double finest_spacing_m(const Meadow& meadow) {
  double finest_m = std::numeric_limits<double>::infinity();
  const auto consider = [&](const NodeGrid& map) {
    if (!map.is_uniform()) finest_m = std::min(finest_m, map.frame().spacing_m);
  };
  for (const PlantedSpecies& species : meadow.species) consider(species.density_per_m2);
  consider(meadow.blade_height);
  if (meadow.color) consider(*meadow.color);
  if (!meadow.ground.is_uniform()) finest_m = std::min(finest_m, meadow.ground.frame().spacing_m);
  return finest_m;
}

std::uint8_t byte_of(double share) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

float value_at(const NodeGrid& map, glm::dvec2 place_m, int channel, float missing) {
  const float value = map.sample(place_m, map.channels() > 1 ? channel : 0);
  return std::isfinite(value) ? value : missing;
}

// What blades of a species look like from above.
struct FromAbove {
  glm::vec3 albedo;
  double area_m2;  // that one shows
};

// What a place contributes to its texel.
struct Sward {
  glm::dvec3 albedo_area{0.0};  // Σ leaf area · albedo
  double area = 0.0;            // leaf area seen from above, per ground area
  double cover = 0.0;
};

Sward sward_at(const Meadow& meadow, const std::vector<FromAbove>& species, glm::dvec2 place_m) {
  Sward sward;
  if (!meadow.ground.has_data(place_m, place_m)) return sward;
  const double length = static_cast<double>(value_at(meadow.blade_height, place_m, 0, 1.0f));
  for (std::size_t s = 0; s < meadow.species.size(); ++s) {
    const double density = static_cast<double>(value_at(meadow.species[s].density_per_m2, place_m, 0, 0.0f));
    const double area = length * species[s].area_m2 * density;
    sward.albedo_area += area * glm::dvec3(species[s].albedo);
    sward.area += area;
  }
  if (meadow.color) {
    for (int channel = 0; channel < 3; ++channel) {
      sward.albedo_area[channel] *= static_cast<double>(value_at(*meadow.color, place_m, channel, 1.0f));
    }
  }
  sward.cover = 1.0 - std::exp(-sward.area);
  return sward;
}

// The mean over `samples` × `samples` places of the texel around `place_m`.
void fill_texel(const Meadow& meadow, const std::vector<FromAbove>& species, glm::dvec2 place_m,
                glm::dvec2 texel_m, int samples, std::uint8_t* texel) {
  Sward sum;
  for (int n = 0; n < samples * samples; ++n) {
    const glm::dvec2 shift =
        (glm::dvec2(n % samples, n / samples) + 0.5) / static_cast<double>(samples) - 0.5;
    glm::dvec2 sample_m = place_m + shift * texel_m;
    if (!meadow.repeats) sample_m = glm::clamp(sample_m, glm::dvec2(0.0), meadow.extent_m);
    const Sward sward = sward_at(meadow, species, sample_m);
    sum.albedo_area += sward.albedo_area;
    sum.area += sward.area;
    sum.cover += sward.cover;
  }
  Kernels kernels;
  for (int channel = 0; channel < 3; ++channel) {
    const double albedo = sum.area > 0.0 ? sum.albedo_area[channel] / sum.area
                                         : static_cast<double>(species[0].albedo[channel]);
    texel[channel] = byte_of(static_cast<double>(kernels.srgb_from_linear(static_cast<float>(albedo))));
  }
  texel[3] = byte_of(sum.cover / (samples * samples));
}

}  // namespace

glm::vec3 mean_albedo(const SpeciesParams& species) {
  Kernels kernels;
  return kernels.mixed(kernels.root_albedo(species, 0.0f, species.dry_share),
                       kernels.tip_albedo(species, 0.0f, species.dry_share), kVisibleTip);
}

FlatMap make_flat_map(const Meadow& meadow, std::span<const double> blade_area_from_above_m2) {
  FlatMap map;
  const double finest_m = finest_spacing_m(meadow);
  const double longest_m = std::max(meadow.extent_m.x, meadow.extent_m.y);
  const double wanted_m = std::max(std::min(finest_m, kCoarsestTexelM), longest_m / (kMostTexels - 1));
  // A repeating map's last texel meets its first one; otherwise texels lie on both borders.
  const int extra = meadow.repeats ? 0 : 1;
  const auto texels = [&](double extent_m) {
    return std::max(1, static_cast<int>(std::lround(extent_m / wanted_m)));
  };
  const glm::ivec2 steps(texels(meadow.extent_m.x), texels(meadow.extent_m.y));
  const glm::dvec2 texel_m = meadow.extent_m / glm::dvec2(steps);
  map.columns = steps.x + extra;
  map.rows = steps.y + extra;
  map.period_m = texel_m * glm::dvec2(map.columns, map.rows);
  map.srgb_and_cover.resize(4 * static_cast<std::size_t>(map.columns) * map.rows);
  const int samples = std::clamp(static_cast<int>(std::ceil(wanted_m / finest_m - 1e-6)), 1, kMostSamples);
  std::vector<FromAbove> species;
  for (std::size_t s = 0; s < meadow.species.size(); ++s) {
    species.push_back({mean_albedo(meadow.species[s].species.params), blade_area_from_above_m2[s]});
  }
  oneapi::tbb::parallel_for(0, map.rows, [&](int row) {
    for (int column = 0; column < map.columns; ++column) {
      fill_texel(meadow, species, texel_m * glm::dvec2(column, row), texel_m, samples,
                 &map.srgb_and_cover[4 * (static_cast<std::size_t>(row) * map.columns + column)]);
    }
  });
  return map;
}

}  // namespace prairie
