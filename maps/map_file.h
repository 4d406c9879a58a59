// Opens a person's raster as a node grid: any image that OpenImageIO reads, and what is georeferenced by
// GDAL, with its place on Earth, its nodata, masks, scale and units understood, and nothing believed before
// it is checked (docs/design.md, D8).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/warning.h"
#include "maps/node_grid.h"

namespace prairie {

class WorkerProcess;

/// How a raster's values become a feature's values; every member that is not set is found out from the file.
struct MapSpec {
  std::filesystem::path file;  // absolute, or relative to the process; or a folder of rasters
  std::vector<std::filesystem::path> more_files;  // laid beside `file`: a mosaic
  std::string field;                              // the scene key that names the file; for messages
  std::optional<std::string> channel;          // a name, "R", "G", "B", "A", or a number that counts from 1
  std::optional<double> spacing_m;             // overrides the file's geo-reference
  std::optional<std::array<double, 2>> range;  // see `MapMeaning`
  std::optional<double> nodata;                // overrides the file's own
  std::optional<double> scale;                 // heights only: metres per unit of the file's values
  std::optional<std::string> crs;              // of a file that does not tell it: "EPSG:…", WKT
  std::optional<std::array<int, 2>> size_px;   // columns and rows of a raw file of 16-bit integers
  double curve = 1.0;                          // density only: exponent G
  double max = 1.0;                            // density and factor: value at the top of the range
  bool repeats = false;
};

enum class MapMeaning {
  kHeight,   // metres; `range` = heights of the values 0 and (integers) the type's largest or (floats) 1
  kDensity,  // max · clamp((v − LO)/(HI − LO), 0, 1)^curve; default range 0,1 (float) or the type's full
             // range; v is what the file says that its values mean (scale and offset)
  kFactor,   // like density with curve 1: a multiplier (blade height, bend)
  kColor,    // three channels, sRGB-decoded where the file is 8/16-bit; linear out
};

/// Where a map lies on Earth, kept for output.
struct GeoReference {
  double pixel_size_m = 1.0;
  double west_m = 0.0;  // of the centre of the south-west pixel
  double south_m = 0.0;
  std::string wkt;  // the coordinate system, empty if unknown
};

struct Map {
  NodeGrid grid;  // origin_m = (0, 0) at the south-west node
  std::optional<GeoReference> geo_reference;
  std::uint64_t content_hash = 0;  // of the file's bytes
  std::vector<Warning> warnings;
};

/// Reads a map within `budget_bytes`; the nodes of one that would not fit go to a temporary file. Image row 0
/// is north unless the file says otherwise. Three equal channels count as one; others need `channel`. Nodata:
/// −9999, ≤ −3.4e38, NaN, the file's own value and, in heights, the customary ones of surveys. A raster that
/// does not lie straight in true metres is resampled, into the system of `scene` where it has one. Decoded by
/// `decoder` (maps/map_work.h), or in this process where there is none. Throws BadInput.
Map read_map(const MapSpec& spec, MapMeaning meaning, std::uint64_t budget_bytes,
             const GeoReference* scene = nullptr, WorkerProcess* decoder = nullptr);

}  // namespace prairie
