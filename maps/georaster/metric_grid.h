// Where the nodes of a map lie that is made of a georeferenced raster: on the raster's own pixels where these
// lie straight in true metres, else on new ones in a metric system of their own, as fine as the pixels are.
#pragma once

#include <optional>
#include <string>

#include "maps/georaster/georaster.h"

namespace prairie {

/// Nodes in true metres: node (column, row) lies at west_m + column · spacing_m, south_m + row · spacing_m.
struct MetricGrid {
  int columns = 0;
  int rows = 0;
  double spacing_m = 1.0;
  double west_m = 0.0;
  double south_m = 0.0;
  std::optional<SpatialReference> reference;

  bool is_resampled = false;
  // Where it is not: node (i, j) is pixel (i, rows − 1 − j), unless columns run west or rows north.
  bool columns_run_west = false;
  bool rows_run_north = false;
  /// One line on why and whereto it is resampled; empty if it is not.
  std::string note;
};

/// What a scene asks of the grid.
struct MetricGridRequest {
  std::optional<double> spacing_m;        // instead of the raster's own
  std::optional<SpatialReference> scene;  // the system that the scene lies in, if it has one
};

/// Where a raster's pixels lie on its own plane.
struct RasterPlace {
  int columns = 0;
  int rows = 0;
  MapFromPixel map_from_pixel{};
  std::optional<SpatialReference> reference;
};

/// How a raster cannot be laid out: what was found, and what would do.
struct LayoutFault {
  std::string found;
  std::string expected;
};

/// Throws LayoutFault where the raster's system, or its place in it, leads to no grid of metres.
MetricGrid metric_grid(const RasterPlace& place, const MetricGridRequest& request);

}  // namespace prairie
