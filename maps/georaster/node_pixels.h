// From the nodes of a grid to the pixels of the raster that it is resampled from.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "maps/georaster/metric_grid.h"

namespace prairie {

/// Places from one plane to another; the same place where either has no coordinate system or both share one.
class PlaneFromPlane {
 public:
  PlaneFromPlane(const std::optional<SpatialReference>& from, const std::optional<SpatialReference>& to);

  /// In place. False where some place cannot be told in the other system.
  bool apply(std::span<glm::dvec2> places) const;

 private:
  double units_per_unit_ = 1.0;
  std::optional<PlaceTransform> transform_;
};

/// Pixel coordinates, counted from the centre of the first pixel, of a grid's nodes.
class NodePixels {
 public:
  NodePixels(const RasterPlace& place, const MetricGrid& grid);

  /// Of a block of at most `kBlockNodes` a side: exactly at 3 × 3 of its nodes, quadratic between (wrong by
  /// less than 1e-4 of a pixel). Nodes that lie nowhere on the raster's plane get NaN.
  void of_block(int column, int row, int columns, int rows, std::span<glm::dvec2> out) const;

  static constexpr int kBlockNodes = 32;

 private:
  glm::dvec2 pixel_at(glm::dvec2 place) const;

  MetricGrid grid_;
  PlaneFromPlane own_from_grid_;
  MapFromPixel pixel_from_map_{};
};

}  // namespace prairie
