#include "maps/map_file.h"

#include <utility>

#include "maps/map_work.h"
#include "maps/node_store.h"

namespace prairie {

Map read_map(const MapSpec& spec, MapMeaning meaning, std::uint64_t budget_bytes, const GeoReference* scene,
             WorkerProcess* decoder) {
  NodeStore store(budget_bytes);
  MapSummary summary =
      decode_map({spec, meaning, scene != nullptr ? scene->wkt : ""}, budget_bytes, decoder, store);
  Map map;
  map.grid = store.release(summary.has_gaps);
  map.geo_reference = std::move(summary.geo_reference);
  map.content_hash = summary.content_hash;
  map.warnings = std::move(summary.warnings);
  return map;
}

}  // namespace prairie
