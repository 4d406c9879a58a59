#include "app/scenes/info.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "generator/plant.h"
#include "world/world.h"

namespace prairie {
namespace {

struct Census {
  std::vector<double> blades;  // per species
  double densest_per_m2 = 0.0;
};

// Rows of tiles are counted in parallel and added in order: the same sums for every number of threads.
Census count_blades(const Meadow& meadow) {
  const TileRange tiles = tiles_of(meadow);
  const std::size_t species = meadow.species.size();
  const auto rows = static_cast<std::size_t>(tiles.last.j - tiles.first.j + 1);
  std::vector<Census> row_counts(rows);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    Census& count = row_counts[row];
    count.blades.assign(species, 0.0);
    for (int i = tiles.first.i; i <= tiles.last.i; ++i) {
      const auto expected = expected_counts(meadow, {i, tiles.first.j + static_cast<int>(row)});
      double of_tile = 0.0;
      for (std::size_t s = 0; s < species; ++s) {
        count.blades[s] += expected[s];
        of_tile += expected[s];
      }
      count.densest_per_m2 = std::max(count.densest_per_m2, of_tile / (meadow.tile_m * meadow.tile_m));
    }
  });
  Census total{.blades = std::vector<double>(species, 0.0)};
  for (const Census& count : row_counts) {
    for (std::size_t s = 0; s < species; ++s) total.blades[s] += count.blades[s];
    total.densest_per_m2 = std::max(total.densest_per_m2, count.densest_per_m2);
  }
  return total;
}

std::vector<std::string> warnings_about(const SceneReport& report, double densest_per_m2) {
  constexpr double kDensePerM2 = 5000.0;  // a well-kept pasture; what is drawn of more cannot be told apart
  std::vector<std::string> warnings;
  if (densest_per_m2 > kDensePerM2) {
    warnings.push_back(
        fmt::format("up to {:.0f} blades per m²: slow to draw, and no denser to the eye than {:.0f}",
                    densest_per_m2, kDensePerM2));
  }
  for (const SpeciesReport& species : report.species) {
    if (species.expected_blades < 1.0) {
      warnings.push_back(
          fmt::format("species.{}: nothing grows; does its density map lie on measured ground, and is "
                      "its range right?",
                      species.name));
    }
  }
  return warnings;
}

}  // namespace

SceneReport describe_scene(const World& world) {
  const Meadow& meadow = world.meadow();
  const TileRange tiles = tiles_of(meadow);
  const Census census = count_blades(meadow);
  SceneReport report;
  report.folder = world.scene().folder.string();
  report.scene_hash = world.scene_hash();
  report.seed = meadow.seed;
  report.extent_m = meadow.extent_m;
  report.repeats = meadow.repeats;
  report.tile_m = meadow.tile_m;
  report.tiles_east = std::int64_t{tiles.last.i} - tiles.first.i + 1;
  report.tiles_north = std::int64_t{tiles.last.j} - tiles.first.j + 1;
  report.height_m = meadow.ground.range();
  const double area_m2 = meadow.extent_m.x * meadow.extent_m.y;
  for (std::size_t s = 0; s < meadow.species.size(); ++s) {
    report.species.push_back({meadow.species[s].species.name, census.blades[s], census.blades[s] / area_m2});
    report.expected_blades += census.blades[s];
  }
  report.maps = world.maps();
  for (const LoadedMap& map : report.maps) report.map_memory_bytes += map.memory_bytes;
  for (const CameraSpec& camera : world.scene().cameras) report.cameras.push_back(camera.name);
  report.wind = world.scene().wind;
  report.conditions = world.scene().conditions.size();
  for (std::size_t n = 0; n < world.movers().size(); ++n) {
    const Mover& mover = world.movers()[n];
    report.movers.push_back({world.scene().movers[n].name, mover.path().kind, mover.path().speed_m_per_s,
                             mover.length_m(), mover.path().loops});
  }
  report.geo_reference = world.geo_reference();
  report.warnings = world.warnings();
  for (std::string& warning : warnings_about(report, census.densest_per_m2)) {
    report.warnings.push_back(std::move(warning));
  }
  return report;
}

}  // namespace prairie
