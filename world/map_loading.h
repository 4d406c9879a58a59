// Opens a scene's maps one after the other, each within its share of the memory budget, and puts each in its
// place.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "maps/map_file.h"

namespace prairie {

/// A map of the scene as it was opened; for reports.
struct LoadedMap {
  std::string field;  // the scene key that names it
  std::filesystem::path file;
  GridFrame frame;
  int channels = 1;
  bool in_memory = true;
  std::uint64_t memory_bytes = 0;  // of its nodes; 0 where they stay on disk
};

/// What opening the maps has brought to light besides their nodes.
struct MapFindings {
  std::optional<GeoReference> geo_reference;            // of the scene's origin
  std::map<std::string, std::uint64_t> content_hashes;  // by MapSpec::field
  std::vector<LoadedMap> maps;
  std::vector<Warning> warnings;
};

class MapLoader {
 public:
  /// The budget is shared by `map_count` maps; what one leaves unused goes to those after it. `decoder`: as
  /// for read_map.
  MapLoader(std::uint64_t budget_bytes, int map_count, WorkerProcess* decoder = nullptr);

  /// The map that the ground comes from: its south-west node is the scene's origin.
  NodeGrid load_ground(const MapSpec& spec);
  /// Any other map, placed by its geo-reference if it and the scene have one. Without a ground map, the first
  /// map with a geo-reference gives the scene its own.
  NodeGrid load(const MapSpec& spec, MapMeaning meaning);

  /// Once all maps are open: a map that misses the box (0, 0)…extent_m raises BadInput, one that covers only
  /// part of it a warning.
  void check_cover(glm::dvec2 extent_m);

  MapFindings& findings() { return findings_; }

 private:
  Map read(const MapSpec& spec, MapMeaning meaning);
  NodeGrid keep(const MapSpec& spec, NodeGrid grid);

  std::uint64_t remaining_bytes_;
  int remaining_maps_;
  WorkerProcess* decoder_;
  bool has_ground_map_ = false;
  MapFindings findings_;
};

}  // namespace prairie
