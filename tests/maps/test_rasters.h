// Georeferenced rasters that the tests make with GDAL, in all the ways in which people's rasters differ.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "maps/georaster/georaster.h"

namespace prairie::testing {

struct RasterPlan {
  std::string driver = "GTiff";
  std::vector<std::string> options = {};  // of its creation
  std::string type = "Float32";           // as GDAL names it
  int columns = 40;
  int rows = 30;
  int bands = 1;
  std::optional<MapFromPixel> place = {};
  std::string system = {};  // "EPSG:32614"
  std::optional<std::array<double, 2>> scale_offset = {};
  std::optional<double> nodata = {};
  std::string unit = {};
  bool has_mask = false;        // of the whole: valid where `is_valid` says so
  bool mask_is_beside = false;  // in a file of its own
  std::function<bool(int column, int row)> is_valid = {};
};

/// Stored values by column, row from the file's first, and band from 0. Throws std::runtime_error.
using StoredValue = std::function<double(int column, int row, int band)>;
void write_georaster(const std::filesystem::path& path, const RasterPlan& plan, const StoredValue& value);

/// Pixels of that size whose first row is north and whose outer south-west corner is that.
MapFromPixel north_up(double pixel_m, double west, double south, int rows);

/// The same, turned about its first corner, counter-clockwise.
MapFromPixel turned(const MapFromPixel& place, double angle_rad);

}  // namespace prairie::testing
