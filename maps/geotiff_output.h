// Grids out as GeoTIFF, encoded in memory by GDAL, with their place on Earth.
#pragma once

#include <cstddef>
#include <vector>

#include "maps/map_file.h"
#include "maps/node_grid.h"

namespace prairie {

/// One-channel float GeoTIFF of a grid in memory (deflate, predictor 3); NaN becomes nodata −9999.
/// `geo_reference` gives its place and coordinate system; without it the grid's own frame does, without one.
std::vector<std::byte> encode_geotiff(const NodeGrid& grid, const GeoReference* geo_reference);

}  // namespace prairie
