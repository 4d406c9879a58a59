#include "lod/strip_plan.h"

#include <cmath>
#include <glm/common.hpp>

#include "generator/cell_seed.h"
#include "generator/cell_table.h"

namespace prairie {
namespace {

constexpr int kSteps = layouts::kStripQuads;
static_assert(kSteps == 4, "a StripTile holds four heights a side");

// Mean of the bilinear map over a cell, from four places; nothing grows where the map has no data.
float cell_mean(const NodeGrid& map, glm::dvec2 min_m, double side_m) {
  float sum = 0.0f;
  for (int n = 0; n < 4; ++n) {
    const float value =
        map.sample(min_m + side_m * glm::dvec2(n % 2 == 0 ? 0.25 : 0.75, n < 2 ? 0.25 : 0.75));
    if (value > 0.0f) sum += value;  // false for NaN
  }
  return 0.25f * sum;
}

float factor_at(const NodeGrid& map, glm::dvec2 place_m, int channel) {
  const float value = map.sample(place_m, channel);
  return std::isfinite(value) ? value : 1.0f;
}

}  // namespace

double TileDensity::mean_per_m2(std::size_t species) const {
  const glm::vec4 cells = cells_per_m2[species];
  return 0.25 * static_cast<double>(cells.x + cells.y + cells.z + cells.w);
}

double TileDensity::sum_per_m2() const {
  double sum = 0.0;
  for (std::size_t s = 0; s < cells_per_m2.size(); ++s) sum += mean_per_m2(s);
  return sum;
}

TileDensity tile_density(const Meadow& meadow, TileId tile) {
  const double cell_m = meadow.tile_m / kCellsPerSide;
  const glm::dvec2 origin_m = tile_origin_m(meadow, tile);
  TileDensity density;
  density.cells_per_m2.resize(meadow.species.size(), glm::vec4(0.0f));
  for (int cell = 0; cell < kCellsPerTile; ++cell) {
    const glm::dvec2 min_m = origin_m + glm::dvec2(cell_offset_m(meadow, cell));
    if (!meadow.ground.has_data(min_m, min_m + cell_m)) continue;
    if (!meadow.repeats &&
        (min_m.x >= meadow.extent_m.x || min_m.y >= meadow.extent_m.y || min_m.x < 0.0 || min_m.y < 0.0)) {
      continue;
    }
    for (std::size_t s = 0; s < meadow.species.size(); ++s) {
      const NodeGrid& map = meadow.species[s].density_per_m2;
      density.cells_per_m2[s][cell] =
          map.is_uniform() ? map.sample({0.0, 0.0}) : cell_mean(map, min_m, cell_m);
    }
  }
  return density;
}

void append_strips(const Meadow& meadow, TileId tile, const TileDensity& density, glm::dvec3 eye_m,
                   float grown, std::vector<StripTile>& strips) {
  const glm::dvec2 origin_m = tile_origin_m(meadow, tile);
  const double base_m = tile_base_m(meadow, tile);
  float heights_m[(kSteps + 1) * (kSteps + 1)];
  meadow.ground.sample_lattice(origin_m, meadow.tile_m / kSteps, kSteps + 1, kSteps + 1, heights_m);
  const auto height = [&](int column, int row) {
    return static_cast<float>(static_cast<double>(heights_m[row * (kSteps + 1) + column]) - base_m);
  };
  const glm::dvec2 centre_m = origin_m + 0.5 * meadow.tile_m;
  StripTile strip{};
  strip.eye_from_tile_m = glm::vec3(glm::dvec3(origin_m, base_m) - eye_m);
  strip.side_m = static_cast<float>(meadow.tile_m);
  strip.grown = grown;
  strip.blade_height = factor_at(meadow.blade_height, centre_m, 0);
  strip.color = meadow.color
                    ? glm::vec3(factor_at(*meadow.color, centre_m, 0), factor_at(*meadow.color, centre_m, 1),
                                factor_at(*meadow.color, centre_m, 2))
                    : glm::vec3(1.0f);
  for (int n = 0; n < kSteps; ++n) {
    strip.south_m[n] = height(n, 0);
    strip.east_m[n] = height(kSteps, n);
    strip.north_m[n] = height(kSteps - n, kSteps);
    strip.west_m[n] = height(0, kSteps - n);
  }
  strip.seed = static_cast<std::uint32_t>(
      mix_bits(meadow.seed ^ (static_cast<std::uint64_t>(static_cast<std::uint32_t>(tile.i)) << 32 |
                              static_cast<std::uint32_t>(tile.j))));
  const double all_per_m2 = density.sum_per_m2();
  for (std::size_t s = 0; s < meadow.species.size(); ++s) {
    const double own_per_m2 = density.mean_per_m2(s);
    if (own_per_m2 <= 0.0) continue;
    strip.species = static_cast<std::uint32_t>(s);
    strip.density_per_m2 = density.cells_per_m2[s];
    strip.other_density_per_m2 = static_cast<float>(all_per_m2 - own_per_m2);
    strips.push_back(strip);
  }
}

}  // namespace prairie
