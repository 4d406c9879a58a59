// Pictures and maps out: encoded in memory by OpenImageIO or libtiff (some encoders report success on a full
// disk), then written atomically.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "maps/map_file.h"
#include "maps/node_grid.h"

namespace prairie {

/// 8-bit sRGB RGB, rows from the top. Deterministic bytes: no clock time, no host name.
std::vector<std::byte> encode_png_rgb8(int width, int height, std::span<const std::uint8_t> rgb);
/// 8- or 16-bit grey data, rows from the top (= north).
std::vector<std::byte> encode_png_grey8(int width, int height, std::span<const std::uint8_t> grey);
std::vector<std::byte> encode_png_grey16(int width, int height, std::span<const std::uint16_t> grey);
/// Linear float RGB, rows from the top, ZIP compression.
std::vector<std::byte> encode_exr_rgb(int width, int height, std::span<const float> rgb);
/// One-channel float GeoTIFF of a grid in memory (deflate, predictor 3); NaN becomes nodata −9999 with tag
/// 42113. `geo_reference` gives tags 33550, 33922 and the CRS keys; without it the grid's own frame does,
/// without a CRS.
std::vector<std::byte> encode_geotiff(const NodeGrid& grid, const GeoReference* geo_reference);

}  // namespace prairie
