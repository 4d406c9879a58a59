// World files: six numbers in a text beside an image that say how large its pixels are and where they lie.
#pragma once

#include <filesystem>
#include <optional>

#include "maps/georaster/georaster.h"

namespace prairie {

/// Of image.pgw, image.pngw, image.wld, … beside image.png; nothing where there is none, or a broken one.
std::optional<MapFromPixel> world_file_place(const std::filesystem::path& image);

/// The coordinate system in image.prj beside an image.
std::optional<SpatialReference> projection_file_reference(const std::filesystem::path& image);

}  // namespace prairie
