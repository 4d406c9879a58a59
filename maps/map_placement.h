// Where a map's nodes lie: what the scene says, else the raster's own geo-reference, else a world file beside
// it.
#pragma once

#include <optional>
#include <string>

#include "maps/georaster/metric_grid.h"
#include "maps/map_file.h"

namespace prairie {

struct MapPlacement {
  MetricGrid grid;
  RasterPlace place;                          // of the pixels, for resampling
  std::optional<GeoReference> geo_reference;  // none where only the scene says how large the pixels are
};

/// Of an image of so many pixels.
MapPlacement place_image(const MapSpec& spec, int columns, int rows, const std::string& scene_wkt);

/// Both throw BadInput where the pixels' size is unknown, or they lie in nothing that leads to metres.
MapPlacement place_georaster(const MapSpec& spec, const Georaster& raster, const std::string& scene_wkt);

}  // namespace prairie
