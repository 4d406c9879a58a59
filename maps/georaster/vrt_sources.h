// A VRT is a text that tells GDAL to open other files, run formulas and read any bytes as pixels. Before GDAL
// sees one it is parsed here: only plain mosaics of rasters that lie in its own folder or below pass.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace prairie {

/// Whether the file begins as a VRT does.
bool is_vrt(const std::filesystem::path& path);

/// All rasters that a VRT leads to, through nested ones too, each once. Throws BadInput (for `field`) where
/// it is no VRT, or holds anything but SimpleSource and ComplexSource of such files.
std::vector<std::filesystem::path> checked_vrt_sources(const std::filesystem::path& vrt,
                                                       const std::string& field);

}  // namespace prairie
