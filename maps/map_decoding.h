// Decodes a map's files, whoever made them, into nodes: the work that is done in a process of its own where
// the files are not trusted.
#pragma once

#include "maps/map_sink.h"

namespace prairie {

struct MapRequest {
  MapSpec spec;
  MapMeaning meaning = MapMeaning::kHeight;
  std::string scene_wkt;  // the coordinate system that the map is brought into; empty: its own
};

/// Where a map's nodes would lie, without reading them.
struct MapLayout {
  int columns = 0;
  int rows = 0;
  std::optional<double> spacing_m;            // none where neither the file nor the scene tells it
  std::optional<GeoReference> geo_reference;  // none where the file does not tell it
};

/// Throws BadInput as decode_map does, but not for a spacing that nobody tells.
MapLayout layout_of_map(const MapRequest& request);

/// Throws BadInput; `sink` may then hold a part of the nodes.
MapSummary decode_map(const MapRequest& request, MapSink& sink);

}  // namespace prairie
