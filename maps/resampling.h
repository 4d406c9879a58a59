// A map on nodes that are not its raster's pixels: bilinear between the pixels around each node, after their
// values have become the map's.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "maps/map_placement.h"
#include "maps/map_sink.h"

namespace prairie {

/// The map's values at the pixels of a rectangle, rows from the raster's first, channels interleaved; NaN =
/// no data.
using PixelWindow = std::function<std::vector<float>(const PixelRect& rect)>;

/// Hands all nodes of the placement's grid to `sink`. A node has no data where it lies more than half a pixel
/// outside the raster, or a pixel that counts towards it has none.
void resample(const MapPlacement& placement, int channels, const PixelWindow& window, MapSink& sink);

}  // namespace prairie
