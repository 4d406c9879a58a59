#include "maps/georaster/node_pixels.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace prairie {
namespace {

/// Coordinates that differ from a whole number by rounding alone are meant to be whole: nodes that lie on
/// pixels get their very values.
constexpr double kWhole_px = 1e-6;

double snapped(double coordinate) {
  const double whole = std::nearbyint(coordinate);
  return std::abs(coordinate - whole) < kWhole_px ? whole : coordinate;
}

/// Weights of three values at 0, ½ and 1 (Lagrange).
std::array<double, 3> quadratic_weights(double t) {
  return {(2.0 * t - 1.0) * (t - 1.0), 4.0 * t * (1.0 - t), t * (2.0 * t - 1.0)};
}

MapFromPixel inverse(const MapFromPixel& g) {
  const double determinant = g[1] * g[5] - g[2] * g[4];
  MapFromPixel inverse{};
  inverse[1] = g[5] / determinant;
  inverse[2] = -g[2] / determinant;
  inverse[4] = -g[4] / determinant;
  inverse[5] = g[1] / determinant;
  // The first pixel's corner serves as origin: coordinates of millions would cost digits.
  inverse[0] = g[0];
  inverse[3] = g[3];
  return inverse;
}

}  // namespace

PlaneFromPlane::PlaneFromPlane(const std::optional<SpatialReference>& from,
                               const std::optional<SpatialReference>& to) {
  if (!from || !from->is_on_earth() || !to) {
    if (from) units_per_unit_ = from->metres_per_unit() / (to ? to->metres_per_unit() : 1.0);
    if (!from && to) units_per_unit_ = 1.0 / to->metres_per_unit();
    return;
  }
  if (!from->has_plane_of(*to)) transform_.emplace(*from, *to);
}

bool PlaneFromPlane::apply(std::span<glm::dvec2> places) const {
  if (transform_) return transform_->apply(places);
  for (glm::dvec2& place : places) place *= units_per_unit_;
  return true;
}

NodePixels::NodePixels(const RasterPlace& place, const MetricGrid& grid)
    : grid_(grid),
      own_from_grid_(grid.reference, place.reference),
      pixel_from_map_(inverse(place.map_from_pixel)) {}

glm::dvec2 NodePixels::pixel_at(glm::dvec2 place) const {
  const MapFromPixel& p = pixel_from_map_;
  const double east = place.x - p[0], north = place.y - p[3];
  return {p[1] * east + p[2] * north - 0.5, p[4] * east + p[5] * north - 0.5};
}

void NodePixels::of_block(int column, int row, int columns, int rows, std::span<glm::dvec2> out) const {
  assert(columns <= kBlockNodes && rows <= kBlockNodes);
  std::array<glm::dvec2, 9> known;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      known[static_cast<std::size_t>(3 * j + i)] = {
          grid_.west_m + (column + 0.5 * i * (columns - 1)) * grid_.spacing_m,
          grid_.south_m + (row + 0.5 * j * (rows - 1)) * grid_.spacing_m};
    }
  }
  if (!own_from_grid_.apply(known)) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    std::ranges::fill(out, glm::dvec2(kNaN));
    return;
  }
  for (glm::dvec2& place : known) place = pixel_at(place);
  for (int j = 0; j < rows; ++j) {
    const std::array<double, 3> v = quadratic_weights(rows > 1 ? static_cast<double>(j) / (rows - 1) : 0.0);
    for (int i = 0; i < columns; ++i) {
      const std::array<double, 3> u =
          quadratic_weights(columns > 1 ? static_cast<double>(i) / (columns - 1) : 0.0);
      glm::dvec2 at(0.0);
      for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t a = 0; a < 3; ++a) at += u[a] * v[b] * known[3 * b + a];
      }
      out[static_cast<std::size_t>(j * columns + i)] = {snapped(at.x), snapped(at.y)};
    }
  }
}

}  // namespace prairie
