#include "app/scenes/info.h"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "generator/plant.h"

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

nlohmann::ordered_json json_of(const LoadedMap& map) {
  return {{"field", map.field},
          {"file", map.file.filename().string()},
          {"columns", map.frame.columns},
          {"rows", map.frame.rows},
          {"channels", map.channels},
          {"spacing_m", map.frame.spacing_m},
          {"origin_m", {map.frame.origin_m.x, map.frame.origin_m.y}},
          {"repeats", map.frame.repeats},
          {"in_memory", map.in_memory},
          {"memory_bytes", map.memory_bytes}};
}

// GeoTIFF keys come in fours after a header of four; 3072 names the projected coordinate system.
bool names_coordinate_system(const GeoReference& reference) {
  constexpr std::uint16_t kProjectedCoordinateSystem = 3072;
  for (std::size_t k = 4; k + 3 < reference.geo_keys.size(); k += 4) {
    if (reference.geo_keys[k] == kProjectedCoordinateSystem) return true;
  }
  return false;
}

const char* name_of(MoverKind kind) {
  return kind == MoverKind::kStone ? "stone" : "cart";
}

std::string described(const WindSpec& wind) {
  const std::string mean = wind.file
                               ? wind.file->filename().string()
                               : fmt::format("{} m/s towards {}°", wind.speed_m_per_s, wind.heading_deg);
  return fmt::format("{}, turbulence {}, {} gusts, tornadoes and breezes", mean, wind.turbulence,
                     wind.primitives.size());
}

nlohmann::ordered_json json_of(const WindSpec& wind) {
  nlohmann::ordered_json json;
  if (wind.file) {
    json["file"] = wind.file->filename().string();
  } else {
    json["speed_m_per_s"] = wind.speed_m_per_s;
    json["heading_deg"] = wind.heading_deg;
  }
  json["turbulence"] = wind.turbulence;
  json["primitives"] = wind.primitives.size();
  return json;
}

std::string readable_bytes(std::uint64_t bytes) {
  constexpr double kMebibyte = 1024.0 * 1024.0;
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / kMebibyte);
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

void print_text(const SceneReport& report, std::ostream& out) {
  fmt::print(out, "scene     {}\n", report.folder);
  fmt::print(out, "hash      {:016x}, seed {}\n", report.scene_hash, report.seed);
  fmt::print(out, "extent    {:.1f} × {:.1f} m{}\n", report.extent_m.x, report.extent_m.y,
             report.repeats ? ", repeated endlessly" : "");
  fmt::print(out, "tiles     {} × {} of {} m\n", report.tiles_east, report.tiles_north, report.tile_m);
  fmt::print(out, "heights   {:.2f} to {:.2f} m\n", report.height_m.min_m, report.height_m.max_m);
  if (report.geo_reference) {
    fmt::print(out, "origin    {:.2f} east, {:.2f} north{}\n", report.geo_reference->west_m,
               report.geo_reference->south_m,
               names_coordinate_system(*report.geo_reference) ? "" : ", coordinate system unknown");
  }
  for (const SpeciesReport& species : report.species) {
    fmt::print(out, "species   {}: {:.0f} blades expected, {:.1f} per m²\n", species.name,
               species.expected_blades, species.mean_per_m2);
  }
  fmt::print(out, "blades    {:.0f} expected\n", report.expected_blades);
  for (const LoadedMap& map : report.maps) {
    fmt::print(out, "map       {} = {}: {} × {} nodes, {} m apart, {}\n", map.field,
               map.file.filename().string(), map.frame.columns, map.frame.rows, map.frame.spacing_m,
               map.in_memory ? readable_bytes(map.memory_bytes) : "read from disk as needed");
  }
  fmt::print(out, "memory    {} for maps\n", readable_bytes(report.map_memory_bytes));
  fmt::print(out, "cameras   {}\n", fmt::join(report.cameras, ", "));
  if (report.wind) fmt::print(out, "wind      {}\n", described(*report.wind));
  if (report.conditions > 0) fmt::print(out, "grass     {} conditions come over it\n", report.conditions);
  for (const MoverReport& mover : report.movers) {
    fmt::print(out, "mover     {}: {}, {} m/s along {:.1f} m{}\n", mover.name, name_of(mover.kind),
               mover.speed_m_per_s, mover.length_m, mover.loops ? ", round and round" : "");
  }
  for (const std::string& warning : report.warnings) fmt::print(out, "warning   {}\n", warning);
}

void print_json(const SceneReport& report, std::ostream& out) {
  nlohmann::ordered_json json;
  json["folder"] = report.folder;
  json["scene_hash"] = fmt::format("{:016x}", report.scene_hash);
  json["seed"] = report.seed;
  json["extent_m"] = {report.extent_m.x, report.extent_m.y};
  json["repeats"] = report.repeats;
  json["tile_m"] = report.tile_m;
  json["tiles"] = {report.tiles_east, report.tiles_north};
  json["height_min_m"] = report.height_m.min_m;
  json["height_max_m"] = report.height_m.max_m;
  json["species"] = nlohmann::ordered_json::array();
  for (const SpeciesReport& species : report.species) {
    json["species"].push_back({{"name", species.name},
                               {"expected_blades", species.expected_blades},
                               {"mean_per_m2", species.mean_per_m2}});
  }
  json["expected_blades"] = report.expected_blades;
  json["maps"] = nlohmann::ordered_json::array();
  for (const LoadedMap& map : report.maps) json["maps"].push_back(json_of(map));
  json["map_memory_bytes"] = report.map_memory_bytes;
  json["cameras"] = report.cameras;
  json["wind"] = nullptr;
  if (report.wind) json["wind"] = json_of(*report.wind);
  json["conditions"] = report.conditions;
  json["movers"] = nlohmann::ordered_json::array();
  for (const MoverReport& mover : report.movers) {
    json["movers"].push_back({{"name", mover.name},
                              {"kind", name_of(mover.kind)},
                              {"speed_m_per_s", mover.speed_m_per_s},
                              {"length_m", mover.length_m},
                              {"loops", mover.loops}});
  }
  json["geo_reference"] = nullptr;
  if (report.geo_reference) {
    json["geo_reference"] = {{"west_m", report.geo_reference->west_m},
                             {"south_m", report.geo_reference->south_m},
                             {"pixel_size_m", report.geo_reference->pixel_size_m},
                             {"has_coordinate_system", names_coordinate_system(*report.geo_reference)}};
  }
  json["warnings"] = report.warnings;
  // Paths may hold bytes that are no UTF-8; they are replaced, not refused.
  out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace prairie
