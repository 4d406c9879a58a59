// Grids out as GeoTIFF, encoded in memory by libtiff, which unlike OpenImageIO lets one write the tags that
// place them on Earth.
#pragma once

#include <cstddef>
#include <vector>

#include "maps/map_file.h"
#include "maps/node_grid.h"

namespace prairie {

/// One-channel float GeoTIFF of a grid in memory (deflate, predictor 3); NaN becomes nodata −9999 with tag
/// 42113. `geo_reference` gives tags 33550, 33922 and the CRS keys; without it the grid's own frame does,
/// without a CRS.
std::vector<std::byte> encode_geotiff(const NodeGrid& grid, const GeoReference* geo_reference);

}  // namespace prairie
