// Opens a person's raster as a node grid: any image that OpenImageIO reads (samples of 8, 16 or 32 bits),
// with its geo-reference, its nodata value and its value range understood, and nothing believed before it is
// checked (docs/design.md, D8).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "maps/node_grid.h"

namespace prairie {

/// How a raster's values become a feature's values; every member that is not set is found out from the file.
struct MapSpec {
  std::filesystem::path file;                  // absolute, or relative to the process
  std::string field;                           // the scene key that names the file; for messages
  std::optional<std::string> channel;          // "R", "G", "B", "A" or the file's own channel name
  std::optional<double> spacing_m;             // overrides the file's geo-reference
  std::optional<std::array<double, 2>> range;  // see `MapMeaning`
  std::optional<double> nodata;                // overrides the file's own
  double curve = 1.0;                          // density only: exponent G
  double max = 1.0;                            // density and factor: value at the top of the range
  bool repeats = false;
};

enum class MapMeaning {
  kHeight,   // metres; integer files need `range` = heights of 0 and of the type's largest value
  kDensity,  // max · clamp((v − LO)/(HI − LO), 0, 1)^curve; default range 0,1 (float) or the type's full
             // range
  kFactor,   // like density with curve 1: a multiplier (blade height, bend)
  kColor,    // three channels, sRGB-decoded where the file is 8/16-bit; linear out
};

/// What a file says about where it lies on Earth, kept for output. Read from GeoTIFF tags 33550, 33922,
/// 34735–34737, 42113, or from a world file beside the image.
struct GeoReference {
  double pixel_size_m = 1.0;
  double west_m = 0.0;  // of the centre of the south-west pixel
  double south_m = 0.0;
  std::vector<std::uint16_t> geo_keys;  // tag 34735, empty if unknown
  std::vector<double> geo_doubles;      // tag 34736
  std::string geo_ascii;                // tag 34737
};

struct Map {
  NodeGrid grid;  // origin_m = (0, 0) at the south-west node
  std::optional<GeoReference> geo_reference;
  std::uint64_t content_hash = 0;     // of the file's bytes
  std::vector<std::string> warnings;  // "half of the nodes have no data", …
};

/// Reads a map within `budget_bytes`; a map that would not fit stays on disk behind OpenImageIO's cache.
/// Image row 0 is north. Three equal channels count as one; others need `channel`. Nodata: −9999, ≤ −3.4e38,
/// NaN and the file's own value. Throws BadInput.
Map read_map(const MapSpec& spec, MapMeaning meaning, std::uint64_t budget_bytes);

}  // namespace prairie
