#include "maps/map_placement.h"

#include <fmt/format.h>

#include "files/error.h"
#include "maps/georaster/world_file.h"

namespace prairie {
namespace {

constexpr const char* kGiveSpacing = "`spacing_m`, the metres between neighbouring pixels";

MapPlacement without_reference(double spacing_m, int columns, int rows) {
  MapPlacement placement;
  placement.grid.columns = columns;
  placement.grid.rows = rows;
  placement.grid.spacing_m = spacing_m;
  return placement;
}

std::optional<SpatialReference> named_system(const MapSpec& spec) {
  if (!spec.crs) return std::nullopt;
  std::optional<SpatialReference> reference = SpatialReference::of_name(*spec.crs);
  if (!reference) {
    throw BadInput(spec.file.string(), spec.field, fmt::format("`crs` of {:.100}", *spec.crs),
                   "a coordinate system: EPSG:… or WKT");
  }
  return reference;
}

MapPlacement place_pixels(const MapSpec& spec, RasterPlace place, const std::string& scene_wkt) {
  if (!place.reference) place.reference = named_system(spec);
  const MetricGridRequest request{.spacing_m = spec.spacing_m, .scene = SpatialReference::of_wkt(scene_wkt)};
  MapPlacement placement;
  try {
    placement.grid = metric_grid(place, request);
  } catch (const LayoutFault& fault) {
    // A nonsensical reference is nobody's business where the scene says the size itself.
    if (spec.spacing_m) return without_reference(*spec.spacing_m, place.columns, place.rows);
    throw BadInput(spec.file.string(), spec.field, fault.found, fault.expected);
  }
  const MetricGrid& grid = placement.grid;
  placement.geo_reference = GeoReference{.pixel_size_m = grid.spacing_m,
                                         .west_m = grid.west_m,
                                         .south_m = grid.south_m,
                                         .wkt = grid.reference ? grid.reference->wkt() : ""};
  placement.place = std::move(place);
  return placement;
}

}  // namespace

MapPlacement place_image(const MapSpec& spec, int columns, int rows, const std::string& scene_wkt) {
  if (const std::optional<MapFromPixel> pixels = world_file_place(spec.file))
    return place_pixels(spec, {columns, rows, *pixels, projection_file_reference(spec.file)}, scene_wkt);
  if (spec.spacing_m) return without_reference(*spec.spacing_m, columns, rows);
  throw BadInput(spec.file.string(), spec.field, "no geo-reference", kGiveSpacing);
}

MapPlacement place_georaster(const MapSpec& spec, const Georaster& raster, const std::string& scene_wkt) {
  if (!raster.map_from_pixel()) {
    if (spec.spacing_m && !raster.has_control_points())
      return without_reference(*spec.spacing_m, raster.columns(), raster.rows());
    if (raster.has_control_points()) {
      throw BadInput(spec.file.string(), spec.field, "control points instead of a geo-reference",
                     "pixels in their places: gdalwarp IN OUT.tif");
    }
    throw BadInput(spec.file.string(), spec.field, "no geo-reference", kGiveSpacing);
  }
  return place_pixels(spec, {raster.columns(), raster.rows(), *raster.map_from_pixel(), raster.reference()},
                      scene_wkt);
}

}  // namespace prairie
