#include "app/scenes/info.h"

#include <fmt/format.h>

#include <utility>

#include "generator/blade_census.h"
#include "generator/tiles.h"
#include "world/world.h"

namespace prairie {
namespace {

std::vector<Warning> warnings_about(const SceneReport& report, double densest_per_m2) {
  constexpr double kDensePerM2 = 5000.0;  // a well-kept pasture; what is drawn of more cannot be told apart
  std::vector<Warning> warnings;
  if (densest_per_m2 > kDensePerM2) {
    warnings.push_back(
        {"dense",
         fmt::format("up to {:.0f} blades per m²: slow to draw, and no denser to the eye than {:.0f}",
                     densest_per_m2, kDensePerM2)});
  }
  for (const SpeciesReport& species : report.species) {
    if (species.expected_blades < 1.0) {
      warnings.push_back({"nothing-grows", fmt::format("species.{}: nothing grows; does its density map lie "
                                                       "on measured ground, and is its range right?",
                                                       species.name)});
    }
  }
  return warnings;
}

}  // namespace

SceneReport describe_scene(const World& world) {
  const Meadow& meadow = world.meadow();
  const TileRange tiles = tiles_of(meadow);
  const BladeCensus census = blade_census(meadow);
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
  for (Warning& warning : warnings_about(report, census.densest_per_m2)) {
    report.warnings.push_back(std::move(warning));
  }
  return report;
}

}  // namespace prairie
