// Reads the tags of a GeoTIFF as they are. OpenImageIO 2.4 does not show them, so libtiff is asked a second
// time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prairie {

/// Empty where the file has no such tag or one of another type; see maps/geotiff_tags.h for their meaning.
struct GeoTags {
  std::vector<double> pixel_scale;
  std::vector<double> tie_points;
  std::vector<double> transformation;
  std::vector<std::uint16_t> keys;
  std::vector<double> doubles;
  std::string ascii;
  std::optional<double> nodata;

  /// The value of a key that holds a number of 16 bits in the directory itself.
  std::optional<std::uint16_t> key(std::uint16_t id) const;
};

/// Nothing unless `path` is a TIFF that libtiff opens.
std::optional<GeoTags> read_geo_tags(const std::filesystem::path& path);

}  // namespace prairie
