// `prairie info`: what a scene is, in numbers, and what looks wrong with its maps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "world/map_loading.h"
#include "world/scene/scene.h"

namespace prairie {

class World;

struct SpeciesReport {
  std::string name;
  double expected_blades = 0.0;
  double mean_per_m2 = 0.0;  // over the whole extent
};

struct MoverReport {
  std::string name;
  MoverKind kind = MoverKind::kStone;
  double speed_m_per_s = 0.0;
  double length_m = 0.0;  // of its path
  bool loops = false;
};

struct SceneReport {
  std::string folder;
  std::uint64_t scene_hash = 0;
  std::uint64_t seed = 0;
  glm::dvec2 extent_m{0.0};
  bool repeats = false;
  double tile_m = 0.0;
  std::int64_t tiles_east = 0;
  std::int64_t tiles_north = 0;
  HeightRange height_m;
  std::vector<SpeciesReport> species;
  double expected_blades = 0.0;
  std::vector<LoadedMap> maps;
  std::uint64_t map_memory_bytes = 0;
  std::vector<std::string> cameras;
  std::optional<WindSpec> wind;
  std::size_t conditions = 0;
  std::vector<MoverReport> movers;
  std::optional<GeoReference> geo_reference;
  std::vector<Warning> warnings;
};

SceneReport describe_scene(const World& world);

}  // namespace prairie
