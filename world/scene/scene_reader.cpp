#include "world/scene/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "world/scene/key_table.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

void read_version(TableReader& root) {
  const auto version = root.integer("version", 0, std::numeric_limits<std::int64_t>::max());
  if (!version) root.refuse_missing("version", fmt::format("version = {}", kSceneVersion));
  if (*version > kSceneVersion) {
    root.refuse("version", fmt::format("version {}, newer than this program", *version),
                fmt::format("version {} (a newer prairie reads this scene)", kSceneVersion));
  }
  if (*version < kSceneVersion) root.refuse("version", fmt::format("version {}", kSceneVersion));
}

/// `section` has its defaults, and is left alone where the table is absent.
template <class Section>
void read_one(TableReader& root, std::string_view name, const KeyTable<Section>& keys, const Scene& so_far,
              Section& section) {
  if (auto table = root.table(name)) read_section(keys, *table, so_far, section);
}

std::optional<MapSpec> read_map(TableReader& root, std::string_view name, MapUse use, const Scene& so_far) {
  auto table = root.table(name);
  if (!table) return std::nullopt;
  MapSpec map = default_map(so_far);
  read_section(map_keys(use), *table, so_far, map);
  return map;
}

void read_maps(TableReader& root, Scene& scene) {
  auto table = root.table("maps");
  if (!table) return;
  scene.blade_height = read_map(*table, "blade_height", MapUse::kFactor, scene);
  scene.bend = read_map(*table, "bend", MapUse::kFactor, scene);
  scene.color = read_map(*table, "color", MapUse::kColor, scene);
  table->refuse_unknown_keys();
}

/// What a scene may have several of.
struct Several {
  const char* key;     // [[key]]
  const char* plural;  // for messages
  std::size_t most = std::numeric_limits<std::size_t>::max();
};

std::vector<TableReader> tables_of(TableReader& root, const Several& several) {
  std::vector<TableReader> tables = root.tables(several.key);
  if (tables.size() > several.most) {
    root.refuse(several.key, fmt::format("more than {} {}", several.most, several.plural),
                fmt::format("at most {}", several.most));
  }
  return tables;
}

template <class Section>
void read_several(TableReader& root, const Several& several, const KeyTable<Section>& keys,
                  const Scene& so_far, std::vector<Section>& sections, const Section& defaults = {}) {
  for (TableReader& table : tables_of(root, several)) {
    Section section = defaults;
    read_section(keys, table, so_far, section);
    sections.push_back(std::move(section));
  }
}

template <class Primitive>
void read_primitives(TableReader& wind, const char* name, const KeyTable<Primitive>& keys,
                     const Scene& so_far, std::vector<WindPrimitive>& primitives) {
  for (TableReader& table : wind.tables(name)) {
    if (primitives.size() == kMaxWindPrimitives) {
      wind.refuse(name, fmt::format("more than {} gusts, tornadoes and breezes", kMaxWindPrimitives),
                  fmt::format("at most {}", kMaxWindPrimitives));
    }
    Primitive primitive;
    read_section(keys, table, so_far, primitive);
    primitives.push_back(primitive);
  }
}

void read_wind(TableReader& root, Scene& scene) {
  auto table = root.table("wind");
  if (!table) return;
  WindSpec wind;
  read_keys(wind_keys(), *table, scene, wind);
  read_primitives(*table, "gust", gust_keys(), scene, wind.primitives);
  read_primitives(*table, "tornado", tornado_keys(), scene, wind.primitives);
  read_primitives(*table, "breeze", breeze_keys(), scene, wind.primitives);
  table->refuse_unknown_keys();
  scene.wind = std::move(wind);
}

template <class Thing>
Obstacle read_thing(TableReader& table, const KeyTable<Thing>& keys, const Scene& so_far) {
  Thing thing;
  read_section(keys, table, so_far, thing);
  return thing;
}

Obstacle read_obstacle(TableReader& table, const Scene& so_far) {
  const auto kind = table.choice("kind", {"trunk", "box", "rock"});
  if (!kind) table.refuse_missing("kind", "\"trunk\", \"box\" or \"rock\"");
  if (*kind == 0) return read_thing(table, trunk_keys(), so_far);
  if (*kind == 1) return read_thing(table, box_keys(), so_far);
  return read_thing(table, rock_keys(), so_far);
}

void read_walkers(TableReader& root, Scene& scene) {
  std::size_t count = 0;
  for (TableReader& table : root.tables("walkers")) {
    WalkerGroup group;
    read_section(walkers_keys(), table, scene, group);
    count += group.count;
    if (count > kMostWalkers) {
      table.refuse("count", fmt::format("{} walkers in all", count), fmt::format("at most {}", kMostWalkers));
    }
    scene.walkers.push_back(std::move(group));
  }
}

void refuse_without_extent(const Scene& scene, const TomlOrigin& origin) {
  const bool has_density_map =
      std::ranges::any_of(scene.species, [](const SpeciesSpec& spec) { return spec.density.has_value(); });
  if (scene.height || scene.extent_m.x > 0.0 || has_density_map) return;
  throw BadInput(origin.file, "ground.size_m", "nothing that says how large the ground is",
                 "a size, a height map or a density map");
}

}  // namespace

Scene scene_from_table(const toml::table& table, const TomlOrigin& origin,
                       const std::filesystem::path& folder) {
  Scene scene;
  scene.folder = folder;
  TableReader root(origin, "", table);
  read_version(root);
  read_keys(top_keys(), root, scene, scene);
  scene.height = read_map(root, "height", MapUse::kHeight, scene);
  read_one(root, "ground", ground_keys(), scene, scene);
  read_several(root, {"species", "species", kMaxSpecies}, species_keys(), scene, scene.species,
               default_species());
  read_maps(root, scene);
  read_several(root, {"camera", "cameras"}, camera_keys(), scene, scene.cameras);
  read_one(root, "sun", sun_keys(), scene, scene.sun);
  read_one(root, "sky", sky_keys(), scene, scene.sun);
  read_one(root, "lod", lod_keys(), scene, scene.lod);
  read_wind(root, scene);
  read_several(root, {"condition", "conditions", kMaxConditions}, condition_keys(), scene, scene.conditions);
  read_one(root, "treading", treading_keys(), scene, scene.treading);
  read_several(root, {"mover", "movers", kMaxMovers}, mover_keys(), scene, scene.movers);
  for (TableReader& obstacle : tables_of(root, {"obstacle", "obstacles", kMaxObstacles}))
    scene.standing.obstacles.push_back(read_obstacle(obstacle, scene));
  read_several(root, {"wall", "walls", kMaxWalls}, wall_keys(), scene, scene.standing.walls);
  read_several(root, {"goal", "goals", kMostGoals}, goal_keys(), scene, scene.goals);
  read_walkers(root, scene);
  root.refuse_unknown_keys();
  if (scene.species.empty()) root.refuse_missing("species", "at least one [[species]]");
  refuse_without_extent(scene, origin);
  return scene;
}

}  // namespace prairie
