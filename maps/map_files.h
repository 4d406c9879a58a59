// The files that one map is made of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "maps/map_file.h"

namespace prairie {

/// The file, or those of a mosaic: the named ones, and of a folder all georeferenced rasters in it, by name.
/// Throws BadInput where a folder holds none.
std::vector<std::filesystem::path> files_of_map(const MapSpec& spec);

/// What lies beside a raster and tells more of it: world file, .prj, .msk, .aux.xml; of a VRT all that it
/// leads to and what lies beside that. Throws BadInput where a VRT leads where it may not.
std::vector<std::filesystem::path> companions_of(const std::filesystem::path& raster,
                                                 const std::string& field);

/// Of one file's bytes; of several, of all their bytes one after the other.
std::uint64_t content_hash(const std::vector<std::filesystem::path>& files, const std::string& field);

}  // namespace prairie
