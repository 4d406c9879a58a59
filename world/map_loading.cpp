#include "world/map_loading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "files/error.h"
#include "world/placed_map.h"

namespace prairie {
namespace {

std::uint64_t node_bytes(const NodeGrid& grid) {
  if (!grid.in_memory() || grid.is_uniform()) return 0;
  const GridFrame& frame = grid.frame();
  return std::uint64_t{sizeof(float)} * static_cast<std::uint64_t>(frame.columns) *
         static_cast<std::uint64_t>(frame.rows) * static_cast<std::uint64_t>(grid.channels());
}

std::string where_it_lies(const GridFrame& frame) {
  const glm::dvec2 far_m = frame.far_corner_m();
  return fmt::format("a map from ({:.1f}, {:.1f}) to ({:.1f}, {:.1f}) m", frame.origin_m.x, frame.origin_m.y,
                     far_m.x, far_m.y);
}

}  // namespace

MapLoader::MapLoader(std::uint64_t budget_bytes, int map_count, WorkerProcess* decoder)
    : remaining_bytes_(budget_bytes), remaining_maps_(map_count), decoder_(decoder) {}

Map MapLoader::read(const MapSpec& spec, MapMeaning meaning) {
  assert(remaining_maps_ > 0);
  // Half of the share stays free for the work on the map: moving it, filling its gaps.
  const std::uint64_t share_bytes = remaining_bytes_ / static_cast<std::uint64_t>(remaining_maps_) / 2;
  const GeoReference* scene = findings_.geo_reference ? &*findings_.geo_reference : nullptr;
  Map map = read_map(spec, meaning, share_bytes, scene, decoder_);
  --remaining_maps_;
  remaining_bytes_ -= std::min(remaining_bytes_, node_bytes(map.grid));
  findings_.content_hashes[spec.field] = map.content_hash;
  findings_.warnings.insert(findings_.warnings.end(), map.warnings.begin(), map.warnings.end());
  return map;
}

NodeGrid MapLoader::keep(const MapSpec& spec, NodeGrid grid) {
  findings_.maps.push_back({.field = spec.field,
                            .file = spec.file,
                            .frame = grid.frame(),
                            .channels = grid.channels(),
                            .in_memory = grid.in_memory(),
                            .memory_bytes = node_bytes(grid)});
  return grid;
}

NodeGrid MapLoader::load_ground(const MapSpec& spec) {
  assert(findings_.maps.empty());
  Map map = read(spec, MapMeaning::kHeight);
  has_ground_map_ = true;
  findings_.geo_reference = std::move(map.geo_reference);
  return keep(spec, std::move(map.grid));
}

NodeGrid MapLoader::load(const MapSpec& spec, MapMeaning meaning) {
  Map map = read(spec, meaning);
  if (!map.geo_reference) return keep(spec, std::move(map.grid));
  if (!findings_.geo_reference) {
    if (!has_ground_map_) findings_.geo_reference = std::move(map.geo_reference);
    return keep(spec, std::move(map.grid));
  }
  const glm::dvec2 origin_m = origin_in_scene_m(*map.geo_reference, *findings_.geo_reference);
  return keep(spec, placed_at(std::move(map.grid), origin_m));
}

void MapLoader::check_cover(glm::dvec2 extent_m) {
  for (std::size_t k = has_ground_map_ ? 1 : 0; k < findings_.maps.size(); ++k) {
    const LoadedMap& map = findings_.maps[k];
    const double share = covered_share(map.frame, extent_m);
    if (share <= 0.0) {
      throw BadInput(
          map.file.string(), map.field, where_it_lies(map.frame),
          fmt::format("a map that reaches the ground, (0, 0) to ({:.1f}, {:.1f}) m", extent_m.x, extent_m.y));
    }
    constexpr double kNearlyAll = 0.999;
    if (share < kNearlyAll) {
      findings_.warnings.push_back(
          {"covers-part", fmt::format("{}: {}: covers only {:.1f} % of the ground", map.file.string(),
                                      map.field, std::floor(1000.0 * share) / 10.0)});
    }
  }
}

}  // namespace prairie
