#include "maps/georaster/metric_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "maps/georaster/ground_scale.h"
#include "maps/georaster/node_pixels.h"

namespace prairie {
namespace {

constexpr double kSquareTolerance = 1e-3;
constexpr double kStraightTolerance_px = 1e-3;  // over the whole raster
// A projection that is not made for measuring (Web Mercator at 20°, a zone far from its own) is off by more.
constexpr double kTrueMetresTolerance = 0.03;
constexpr double kMaxSpacing_m = 1e6;
constexpr double kMaxCoordinate_m = 1e9;
constexpr double kMaxGrowth = 16.0;  // nodes per pixel
constexpr int kEdgeSteps = 64;

/// The raster's pixels on its own plane.
struct Pixels {
  glm::dvec2 first_centre;
  glm::dvec2 per_column;
  glm::dvec2 per_row;
  int columns = 0;
  int rows = 0;

  glm::dvec2 centre(double column, double row) const {
    return first_centre + column * per_column + row * per_row;
  }
  glm::dvec2 middle() const { return centre(0.5 * (columns - 1), 0.5 * (rows - 1)); }
};

Pixels pixels_of(const RasterPlace& place) {
  const MapFromPixel& g = place.map_from_pixel;
  return {{g[0] + 0.5 * (g[1] + g[2]), g[3] + 0.5 * (g[4] + g[5])},
          {g[1], g[4]},
          {g[2], g[5]},
          place.columns,
          place.rows};
}

/// Rows that run west to east, columns that run north or south, to a thousandth of a pixel.
bool is_straight(const Pixels& p) {
  return std::abs(p.per_row.x) * p.rows <= kStraightTolerance_px * std::abs(p.per_column.x) &&
         std::abs(p.per_column.y) * p.columns <= kStraightTolerance_px * std::abs(p.per_row.y);
}

bool is_square(const Pixels& p) {
  const double width = std::abs(p.per_column.x), height = std::abs(p.per_row.y);
  return std::abs(width - height) <= kSquareTolerance * width;
}

/// Pixels that are mere fractions of a unit, at places that degrees have.
bool looks_like_degrees(const Pixels& p) {
  const glm::dvec2 first = p.first_centre, last = p.centre(p.columns - 1, p.rows - 1);
  const auto fits = [](glm::dvec2 at) { return std::abs(at.x) <= 360.0 && std::abs(at.y) <= 90.0; };
  return fits(first) && fits(last) && glm::length(p.per_column) < 0.02;
}

void check_pixels(const Pixels& p) {
  for (const glm::dvec2 step : {p.per_column, p.per_row}) {
    const double size = glm::length(step);
    if (!(size > 0.0 && size <= kMaxSpacing_m)) {
      throw LayoutFault{fmt::format("pixels {} wide", size),
                        fmt::format("a positive width of at most {:.0f}", kMaxSpacing_m)};
    }
  }
  const double area = std::abs(p.per_column.x * p.per_row.y - p.per_column.y * p.per_row.x);
  if (!(area > 1e-6 * glm::length(p.per_column) * glm::length(p.per_row)))
    throw LayoutFault{"pixels without an area", "a geo-reference that spans a plane"};
  for (const glm::dvec2 at : {p.first_centre, p.centre(p.columns - 1, p.rows - 1)}) {
    if (!(std::abs(at.x) <= kMaxCoordinate_m && std::abs(at.y) <= kMaxCoordinate_m))
      throw LayoutFault{fmt::format("a position of {}, {}", at.x, at.y), "a place on Earth"};
  }
}

/// Why the raster cannot keep its own pixels; empty if it can.
std::string hindrance(const Pixels& p, const std::optional<SpatialReference>& own,
                      const MetricGridRequest& request) {
  if (own && own->is_geographic()) return "degrees";
  if (own && std::abs(own->metres_per_unit() - 1.0) > 1e-9)
    return fmt::format("units of {} m", own->metres_per_unit());
  if (own && request.scene && own->is_on_earth() && !own->has_plane_of(*request.scene))
    return "another system";
  if (own && own->is_on_earth() && !request.scene) {
    const glm::dvec2 scale = ground_scale(*own, p.middle());
    for (const double s : {scale.x, scale.y}) {
      if (std::abs(s - 1.0) > kTrueMetresTolerance)
        return fmt::format("metres that are {:.3f} m on the ground", s > 0.0 ? 1.0 / s : 0.0);
    }
  }
  if (!is_straight(p)) return "turned pixels";
  if (!is_square(p))
    return fmt::format("pixels of {:.6g} × {:.6g} m", std::abs(p.per_column.x), std::abs(p.per_row.y));
  return "";
}

MetricGrid grid_of_pixels(const Pixels& p, const MetricGridRequest& request) {
  MetricGrid grid;
  grid.columns = p.columns;
  grid.rows = p.rows;
  grid.spacing_m = request.spacing_m.value_or(std::abs(p.per_column.x));
  grid.columns_run_west = p.per_column.x < 0.0;
  grid.rows_run_north = p.per_row.y > 0.0;
  // The place of the first pixel holds; the others follow by the spacing.
  const double north = p.first_centre.y;
  grid.west_m =
      grid.columns_run_west ? p.first_centre.x - (p.columns - 1) * grid.spacing_m : p.first_centre.x;
  grid.south_m = grid.rows_run_north ? north : north - (p.rows - 1) * grid.spacing_m;
  return grid;
}

/// True metres for a raster that is measured in something else.
SpatialReference metric_system(const Pixels& p, const std::optional<SpatialReference>& own,
                               const MetricGridRequest& request) {
  if (request.scene) return *request.scene;
  const bool is_true = !own->is_geographic() && std::abs(own->metres_per_unit() - 1.0) <= 1e-9 && [&] {
    const glm::dvec2 scale = ground_scale(*own, p.middle());
    return std::abs(scale.x - 1.0) <= kTrueMetresTolerance && std::abs(scale.y - 1.0) <= kTrueMetresTolerance;
  }();
  if (is_true) return *own;
  const std::optional<glm::dvec2> middle = longitude_latitude_deg(*own, p.middle());
  if (!middle || middle->y < kLeastUtmLatitudeDeg || middle->y > kMostUtmLatitudeDeg) {
    throw LayoutFault{
        fmt::format("a raster of {} around {:.6g}, {:.6g}", own->name(), p.middle().x, p.middle().y),
        fmt::format("a place between {} and {} degrees of latitude, or metres: gdalwarp -t_srs",
                    kLeastUtmLatitudeDeg, kMostUtmLatitudeDeg)};
  }
  return SpatialReference::utm_at(*middle);
}

/// Plane places of the pixels' outer centres, and how long a pixel's sides are in the middle.
struct Footprint {
  glm::dvec2 least{0.0};
  glm::dvec2 most{0.0};
  double finest_m = 1.0;
};

Footprint footprint(const Pixels& p, const PlaneFromPlane& target_from_own) {
  std::vector<glm::dvec2> places;
  const double right = p.columns - 1, bottom = p.rows - 1;
  for (int k = 0; k <= kEdgeSteps; ++k) {
    const double share = static_cast<double>(k) / kEdgeSteps;
    places.push_back(p.centre(share * right, 0.0));
    places.push_back(p.centre(share * right, bottom));
    places.push_back(p.centre(0.0, share * bottom));
    places.push_back(p.centre(right, share * bottom));
  }
  const std::size_t edge = places.size();
  for (const glm::dvec2 step : {glm::dvec2(0.0), p.per_column, p.per_row})
    places.push_back(p.middle() + step);
  if (!target_from_own.apply(places))
    throw LayoutFault{"a raster that reaches beyond its coordinate system", "a smaller one: gdalwarp -te"};
  Footprint result;
  result.least = result.most = places[0];
  for (std::size_t k = 0; k < edge; ++k) {
    result.least = glm::dvec2(std::min(result.least.x, places[k].x), std::min(result.least.y, places[k].y));
    result.most = glm::dvec2(std::max(result.most.x, places[k].x), std::max(result.most.y, places[k].y));
  }
  result.finest_m =
      std::min(glm::length(places[edge + 1] - places[edge]), glm::length(places[edge + 2] - places[edge]));
  return result;
}

MetricGrid resampled_grid(const Pixels& p, const std::optional<SpatialReference>& own,
                          const MetricGridRequest& request, const std::string& why) {
  MetricGrid grid;
  grid.is_resampled = true;
  if (own && own->is_on_earth()) grid.reference = metric_system(p, own, request);
  const Footprint foot = footprint(p, PlaneFromPlane(own, grid.reference));
  grid.spacing_m = request.spacing_m.value_or(foot.finest_m);
  const glm::dvec2 steps = (foot.most - foot.least) / grid.spacing_m;
  const double pixels = static_cast<double>(p.columns) * p.rows;
  constexpr double kWhole = 1e-6;
  const double columns = std::floor(steps.x + kWhole) + 1.0, rows = std::floor(steps.y + kWhole) + 1.0;
  if (!(grid.spacing_m > 0.0) || !(columns * rows <= std::max(1e6, kMaxGrowth * pixels))) {
    throw LayoutFault{fmt::format("{:.0f} × {:.0f} nodes of {:.4g} m for {} × {} pixels", columns, rows,
                                  grid.spacing_m, p.columns, p.rows),
                      "a raster that fills the rectangle around it, or a larger `spacing_m`"};
  }
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  grid.west_m = foot.least.x;
  grid.south_m = foot.least.y;
  grid.note =
      fmt::format("resampled ({}) to {} × {} nodes of {:.4g} m{}{}", why, grid.columns, grid.rows,
                  grid.spacing_m, grid.reference ? " in " : "", grid.reference ? grid.reference->name() : "");
  return grid;
}

}  // namespace

MetricGrid metric_grid(const RasterPlace& place, const MetricGridRequest& request) {
  const Pixels pixels = pixels_of(place);
  check_pixels(pixels);
  const std::optional<SpatialReference>& own = place.reference;
  if (!own && looks_like_degrees(pixels)) {
    throw LayoutFault{fmt::format("pixels of {:.3g} without a coordinate system, at places like degrees",
                                  glm::length(pixels.per_column)),
                      "a .prj file beside it, or `crs`, such as \"EPSG:4326\" for degrees on WGS 84"};
  }
  const std::string why = hindrance(pixels, own, request);
  if (!why.empty()) return resampled_grid(pixels, own, request, why);
  MetricGrid grid = grid_of_pixels(pixels, request);
  grid.reference = own;
  return grid;
}

}  // namespace prairie
