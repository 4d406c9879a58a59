#include "maps/map_placement.h"

#include <fmt/format.h>

#include <cmath>

#include "files/error.h"
#include "maps/geotiff_tags.h"
#include "maps/world_file.h"

namespace prairie {
namespace {

constexpr double kSquareTolerance = 1e-3;
constexpr double kMaxSpacing_m = 1e6;
constexpr double kMaxCoordinate_m = 1e9;  // no projected position on Earth is further from its origin

constexpr const char* kGiveSpacing = "`spacing_m`, the metres between neighbouring pixels";

/// The raster's pixels on the ground: their size, and the centre of the north-west one.
struct Pixels {
  double width = 0.0;
  double height = 0.0;
  double west = 0.0;
  double north = 0.0;
  bool turned = false;
};

bool is_place(double coordinate) {
  return std::abs(coordinate) <= kMaxCoordinate_m;
}

std::optional<Pixels> pixels_of(const GeoTags& tags) {
  // PixelIsArea: raster coordinates count from the corner of a pixel; PixelIsPoint: from its centre.
  const bool is_point = tags.key(geotiff::kRasterTypeKey) == geotiff::kRasterPixelIsPoint;
  const double centre = is_point ? 0.0 : 0.5;
  if (tags.pixel_scale.size() >= 2) {
    Pixels pixels{tags.pixel_scale[0], tags.pixel_scale[1], 0.0, 0.0, false};
    if (tags.tie_points.size() >= 6) {
      const std::vector<double>& tie = tags.tie_points;
      pixels.west = tie[3] + (centre - tie[0]) * pixels.width;
      pixels.north = tie[4] - (centre - tie[1]) * pixels.height;
    }
    return pixels;
  }
  if (tags.transformation.size() >= 16) {
    const std::vector<double>& m = tags.transformation;
    return Pixels{m[0], -m[5], m[3] + centre * m[0], m[7] + centre * m[5], m[1] != 0.0 || m[4] != 0.0};
  }
  return std::nullopt;
}

Pixels pixels_of(const WorldFile& world) {
  return {world.a, -world.e, world.c, world.f, world.b != 0.0 || world.d != 0.0};
}

/// What keeps the raster from being used as it lies; empty if nothing does.
struct Obstacle {
  std::string found;
  std::string expected;
};

std::optional<Obstacle> obstacle_in(const Pixels& pixels) {
  if (pixels.turned) return Obstacle{"a raster that is turned", "rows that run east"};
  for (const double size : {pixels.width, pixels.height}) {
    if (!(size > 0.0 && size <= kMaxSpacing_m)) {
      return Obstacle{fmt::format("a pixel size of {} × {}", pixels.width, pixels.height),
                      "a positive number of metres, first row north"};
    }
  }
  if (std::abs(pixels.width - pixels.height) > kSquareTolerance * pixels.width) {
    return Obstacle{fmt::format("pixels of {} × {}", pixels.width, pixels.height), "square pixels"};
  }
  if (!is_place(pixels.west) || !is_place(pixels.north)) {
    return Obstacle{fmt::format("a position of {}, {}", pixels.west, pixels.north),
                    "metres of a projected coordinate system"};
  }
  return std::nullopt;
}

std::optional<Obstacle> obstacle_in(const GeoTags& tags) {
  if (tags.key(geotiff::kModelTypeKey) == geotiff::kModelTypeGeographic) {
    return Obstacle{"pixels measured in degrees (a geographic coordinate system)",
                    "metres (a projected coordinate system)"};
  }
  const std::optional<std::uint16_t> unit = tags.key(geotiff::kProjectedLinearUnitsKey);
  if (unit && *unit != geotiff::kLinearUnitMetre) {
    return Obstacle{fmt::format("pixels measured in a unit other than metres (EPSG {})", *unit), "metres"};
  }
  return std::nullopt;
}

}  // namespace

MapPlacement place_map(const MapSpec& spec, const GeoTags* tags, int rows) {
  std::filesystem::path where = spec.file;
  std::optional<Pixels> pixels;
  std::optional<Obstacle> obstacle;
  if (tags != nullptr) {
    pixels = pixels_of(*tags);
    if (pixels) obstacle = obstacle_in(*tags);
  }
  const bool by_tags = pixels.has_value();
  if (!pixels) {
    if (const std::optional<std::filesystem::path> world_path = find_world_file(spec.file)) {
      where = *world_path;
      // A broken world file is nobody's business where the scene says the size itself.
      if (spec.spacing_m) return {*spec.spacing_m, std::nullopt};
      pixels = pixels_of(read_world_file(where));
    }
  }
  if (pixels && !obstacle) obstacle = obstacle_in(*pixels);

  if (spec.spacing_m) {
    if (!pixels || obstacle) return {*spec.spacing_m, std::nullopt};
    pixels->width = pixels->height = *spec.spacing_m;
  }
  if (!pixels) throw BadInput(spec.file.string(), spec.field, "no geo-reference", kGiveSpacing);
  if (obstacle) {
    throw BadInput(where.string(), spec.field, obstacle->found,
                   fmt::format("{}, or {}", obstacle->expected, kGiveSpacing));
  }
  GeoReference reference;
  reference.pixel_size_m = pixels->width;
  reference.west_m = pixels->west;
  reference.south_m = pixels->north - (rows - 1) * pixels->width;
  if (by_tags) {
    reference.geo_keys = tags->keys;
    reference.geo_doubles = tags->doubles;
    reference.geo_ascii = tags->ascii;
  }
  return {pixels->width, std::move(reference)};
}

}  // namespace prairie
