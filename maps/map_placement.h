// Where a raster lies and how large its pixels are: what the scene says, else the GeoTIFF's tags, else a
// world file.
#pragma once

#include <optional>

#include "maps/geo_tags.h"
#include "maps/map_file.h"

namespace prairie {

struct MapPlacement {
  double spacing_m = 1.0;
  std::optional<GeoReference> geo_reference;
};

/// `tags` may be null; `rows` of the raster, whose first row is north. Throws BadInput where the pixel size
/// is unknown, not square, not in metres or the raster turned.
MapPlacement place_map(const MapSpec& spec, const GeoTags* tags, int rows);

}  // namespace prairie
