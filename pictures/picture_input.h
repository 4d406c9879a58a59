// Pictures from files, which are not trusted (pictures/raster_file.h).
#pragma once

#include <filesystem>
#include <string>

#include "pictures/picture.h"

namespace prairie {

/// A picture of three channels or more, of which it takes the first three: of integers as sRGB, of
/// floating-point numbers as linear light, `srgb` then being empty. `cover` is empty. Throws BadInput, which
/// names `field`.
Picture read_picture(const std::filesystem::path& path, const std::string& field);

}  // namespace prairie
