// Rasters that say nothing of a place on Earth: images, and the raw heights of engines.
#pragma once

#include <memory>

#include "maps/map_file.h"
#include "maps/stored_raster.h"

namespace prairie {

/// An image that OpenImageIO reads, or, where `spec` gives a size, a raw file of 16-bit integers, low byte
/// first. `file_bytes`: its size. Throws BadInput.
std::unique_ptr<StoredRaster> open_image(const MapSpec& spec, std::uint64_t file_bytes);

/// Whether the name is one that raw heights have (.r16, .raw), which tell neither size nor type.
bool has_raw_name(const std::filesystem::path& path);

}  // namespace prairie
