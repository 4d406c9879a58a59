#include "lod/thinning.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// 60° over 600 pixels: the picture for which the coefficients below were chosen.
constexpr float kReferencePixel = 0.0019245009f;

struct NormalCone {
  glm::dvec3 axis;
  double spread;  // |n − axis| at most
};

// Normals of the biquadratic ground: its slopes are greatest at the lattice's points or between neighbours,
// which differences of half a cell bound.
NormalCone normals_of(const CellView& cell) {
  const double step_m = 0.5 * cell.side_m;
  const auto height = [&](int row, int column) {
    return static_cast<double>(cell.heights_m[static_cast<std::size_t>(3 * row + column)]);
  };
  double low_x = 1e30, high_x = -1e30, low_y = 1e30, high_y = -1e30;
  for (int line = 0; line < 3; ++line) {
    for (int half = 0; half < 2; ++half) {
      const double x = (height(line, half + 1) - height(line, half)) / step_m;
      const double y = (height(half + 1, line) - height(half, line)) / step_m;
      low_x = std::min(low_x, x);
      high_x = std::max(high_x, x);
      low_y = std::min(low_y, y);
      high_y = std::max(high_y, y);
    }
  }
  // A parabola's end slopes lie half the difference of its chords' slopes beyond them.
  const double spread_x = high_x - low_x;
  const double spread_y = high_y - low_y;
  const glm::dvec3 axis = glm::normalize(glm::dvec3(-0.5 * (low_x + high_x), -0.5 * (low_y + high_y), 1.0));
  return {axis, std::hypot(spread_x, spread_y)};
}

}  // namespace

LodCoefficients lod_coefficients(Quality quality, double blade_distance_m) {
  LodCoefficients lod{};
  switch (quality) {
    case Quality::kLow:
      lod.a1 = 0.25f, lod.a2 = 0.20f, lod.a3 = 0.030f;
      break;
    case Quality::kMedium:
      lod.a1 = 0.15f, lod.a2 = 0.12f, lod.a3 = 0.010f;
      break;
    case Quality::kHigh:
      lod.a1 = 0.05f, lod.a2 = 0.05f, lod.a3 = 0.004f;
      break;
  }
  lod.fade = 0.3f;
  lod.reference_pixel = kReferencePixel;
  lod.fade_start_m = static_cast<float>(0.6 * blade_distance_m);
  lod.fade_end_m = static_cast<float>(blade_distance_m);
  lod.widest_pixels = 2.0f;
  return lod;
}

LodCoefficients all_blades() {
  LodCoefficients lod{};
  lod.a1 = 1e-6f;
  lod.fade = 0.3f;
  lod.reference_pixel = kReferencePixel;
  lod.fade_start_m = 1e9f;
  lod.fade_end_m = 2e9f;
  lod.widest_pixels = 2.0f;
  return lod;
}

double keep_bound(const LodCoefficients& lod, const Camera& camera, const CellView& cell) {
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
                                                  static_cast<float>(nearest_m)));
  };
  return 1.0001 * std::max(keep_at(n_dot_r - spread), keep_at(n_dot_r + spread));
}

std::uint32_t drawn_bound(const PlantedCell& cell, double keep) {
  const double bound = std::ceil(keep * cell.planted - static_cast<double>(cell.rank_offset));
  return static_cast<std::uint32_t>(std::clamp(bound, 0.0, static_cast<double>(cell.planted)));
}

}  // namespace prairie
