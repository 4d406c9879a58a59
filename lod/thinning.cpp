#include "lod/thinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// 60° over 600 pixels: the picture for which the coefficients below were chosen.
constexpr float kReferencePixel = 0.0019245009f;

// Where strips begin to sink, as a share of the distance at which none is left.
constexpr double kFadeStart = 0.75;

struct Bands {
  double spline_start_m, spline_end_m, strip_start_m, strip_end_m;
};

// At the reference pixel.
Bands bands_of(Quality quality) {
  switch (quality) {
    case Quality::kLow:
      return {3.0, 4.0, 9.0, 14.0};
    case Quality::kMedium:
      return {3.4, 4.4, 12.0, 17.0};
    case Quality::kHigh:
      break;
  }
  return {6.0, 8.0, 24.0, 34.0};
}

void set_band(float& start_m, float& end_m, double new_start_m, double new_end_m) {
  start_m = static_cast<float>(new_start_m);
  end_m = static_cast<float>(new_end_m);
}

void never(float& start_m, float& end_m) {
  set_band(start_m, end_m, 1e9, 2e9);
}
void always(float& start_m, float& end_m) {
  set_band(start_m, end_m, -2.0, -1.0);
}

struct NormalCone {
  glm::dvec3 axis;
  double spread;  // |n − axis| at most
};

// The Bézier points of the biquadratic ground through 3 × 3 heights. The surface lies between the least and
// the greatest of them, its slopes between the least and the greatest differences of neighbours.
std::array<double, 9> bezier_points(std::span<const float> heights_m) {
  std::array<double, 9> points;
  std::copy(heights_m.begin(), heights_m.end(), points.begin());
  const auto bend = [&](std::size_t first, std::size_t step) {
    points[first + step] = 2.0 * points[first + step] - 0.5 * (points[first] + points[first + 2 * step]);
  };
  for (std::size_t row = 0; row < 3; ++row) bend(3 * row, 1);
  for (std::size_t column = 0; column < 3; ++column) bend(column, 3);
  return points;
}

NormalCone normals_of(const CellView& cell) {
  const std::array<double, 9> points = bezier_points(cell.heights_m);
  const double step_m = 0.5 * cell.side_m;
  double low_x = 1e30, high_x = -1e30, low_y = 1e30, high_y = -1e30;
  for (std::size_t line = 0; line < 3; ++line) {
    for (std::size_t half = 0; half < 2; ++half) {
      const double x = (points[3 * line + half + 1] - points[3 * line + half]) / step_m;
      const double y = (points[3 * (half + 1) + line] - points[3 * half + line]) / step_m;
      low_x = std::min(low_x, x);
      high_x = std::max(high_x, x);
      low_y = std::min(low_y, y);
      high_y = std::max(high_y, y);
    }
  }
  // Normals differ by no more than their slopes do.
  const glm::dvec3 axis = glm::normalize(glm::dvec3(-0.5 * (low_x + high_x), -0.5 * (low_y + high_y), 1.0));
  return {axis, 0.5 * std::hypot(high_x - low_x, high_y - low_y)};
}

}  // namespace

LodCoefficients tier_coefficients(Tier tier, Quality quality, double blade_distance_m, const Camera& camera) {
  LodCoefficients lod{};
  switch (quality) {
    case Quality::kLow:
      lod.a1 = 0.25f, lod.a2 = 0.20f, lod.a3 = 0.030f;
      lod.grazing = 0.25f, lod.steep = 0.45f;
      break;
    case Quality::kMedium:
      lod.a1 = 0.20f, lod.a2 = 0.22f, lod.a3 = 0.017f;
      lod.grazing = 0.13f, lod.steep = 0.26f;
      break;
    case Quality::kHigh:
      lod.a1 = 0.05f, lod.a2 = 0.05f, lod.a3 = 0.004f;
      lod.grazing = 0.10f, lod.steep = 0.20f;
      break;
  }
  lod.fade = 0.4f;
  lod.reference_pixel = kReferencePixel;
  lod.widest_pixels = 2.0f;
  lod.crowded_per_m2 = 1400.0f;
  // A finer picture shows more of a blade, and strips only look right where they are small.
  const double finer =
      camera.is_orthographic() ? 1.0 : static_cast<double>(kReferencePixel) / camera.pixel_m();
  const Bands bands = bands_of(quality);
  set_band(lod.fade_start_m, lod.fade_end_m, kFadeStart * blade_distance_m, blade_distance_m);
  set_band(lod.spline_start_m, lod.spline_end_m, finer * bands.spline_start_m, finer * bands.spline_end_m);
  // Nearer than that, one sees between the rows of strips, however coarse the picture is.
  constexpr double kLeastStripScale = 0.8;
  const double strip_scale = std::max(finer, kLeastStripScale);
  set_band(lod.strip_start_m, lod.strip_end_m, strip_scale * bands.strip_start_m,
           strip_scale * bands.strip_end_m);
  switch (tier) {
    case Tier::kAuto:
      if (camera.is_orthographic()) {
        // Distance is no matter in a parallel projection; only pixels are.
        never(lod.fade_start_m, lod.fade_end_m);
        never(lod.strip_start_m, lod.strip_end_m);
        always(lod.spline_start_m, lod.spline_end_m);
      }
      break;
    case Tier::kSpline:
    case Tier::kHermite:
      lod.unthinned = 1.0f;
      never(lod.fade_start_m, lod.fade_end_m);
      never(lod.strip_start_m, lod.strip_end_m);
      if (tier == Tier::kSpline) never(lod.spline_start_m, lod.spline_end_m);
      if (tier == Tier::kHermite) always(lod.spline_start_m, lod.spline_end_m);
      break;
    case Tier::kStrip:
      always(lod.strip_start_m, lod.strip_end_m);
      lod.grazing = 2.0f;
      lod.steep = 3.0f;
      break;
    case Tier::kFlat:
      always(lod.fade_start_m, lod.fade_end_m);
      break;
  }
  return lod;
}

HeightRange ground_range(std::span<const float> heights_m) {
  const std::array<double, 9> points = bezier_points(heights_m);
  const auto [low, high] = std::minmax_element(points.begin(), points.end());
  return {static_cast<float>(*low), static_cast<float>(*high)};
}

double keep_bound(const LodCoefficients& lod, const Camera& camera, const CellView& cell, float width_m) {
  const glm::dvec3 centre_m = 0.5 * (cell.box.min_m + cell.box.max_m);
  const double radius_m = 0.5 * glm::length(cell.box.max_m - cell.box.min_m);
  const double nearest_m = std::max(nearest_distance_m(cell.box, camera.eye_m), 1e-3);
  const NormalCone cone = normals_of(cell);

  glm::dvec3 to_eye = -camera.forward();
  double spread = cone.spread;
  if (!camera.is_orthographic()) {
    to_eye = camera.eye_m - centre_m;
    const double distance_m = glm::length(to_eye);
    if (distance_m <= radius_m) return 1e30;
    to_eye /= distance_m;
    spread +=
        2.0 * radius_m / distance_m;  // chord of the angle under which the cell is seen, from its middle
  }
  // visible_size falls and then rises, so that its greatest value over a range is at an end.
  const double n_dot_r = glm::dot(cone.axis, to_eye);
  Kernels kernels;
  const auto keep_at = [&](double x) {
    return static_cast<double>(kernels.keep_share(lod, static_cast<float>(x),
                                                  static_cast<float>(camera.pixel_m_at(nearest_m)),
                                                  static_cast<float>(nearest_m), width_m));
  };
  return 1.0001 * std::max(keep_at(n_dot_r - spread), keep_at(n_dot_r + spread));
}

std::uint32_t drawn_bound(const PlantedCell& cell, double keep) {
  const double bound = std::ceil(keep * cell.planted - static_cast<double>(cell.rank_offset));
  return static_cast<std::uint32_t>(std::clamp(bound, 0.0, static_cast<double>(cell.planted)));
}

}  // namespace prairie
