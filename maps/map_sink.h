// Where the nodes of a map go while it is decoded.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "maps/map_file.h"
#include "maps/node_grid.h"

namespace prairie {

/// Takes a map's nodes in any order, each once.
class MapSink {
 public:
  virtual ~MapSink() = default;
  /// Comes first. Channels of a node are interleaved.
  virtual void begin(const GridFrame& frame, int channels) = 0;
  /// `rect` lies inside the grid; rows from south, NaN = no data.
  virtual void take(const NodeRect& rect, std::span<const float> values) = 0;
};

/// What is known of a map when all its nodes are decoded.
struct MapSummary {
  std::optional<GeoReference> geo_reference;
  std::uint64_t content_hash = 0;
  bool has_gaps = false;
  std::vector<Warning> warnings;
};

}  // namespace prairie
