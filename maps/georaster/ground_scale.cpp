#include "maps/georaster/ground_scale.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace prairie {
namespace {

constexpr double kEquatorRadius_m = 6'378'137.0;
constexpr double kFlattening = 1.0 / 298.257223563;

/// Metres per radian of longitude and of latitude (radii of curvature; Snyder 1987, eq. 4-18 to 4-20).
glm::dvec2 metres_per_radian(double latitude_rad) {
  const double e2 = kFlattening * (2.0 - kFlattening);
  const double w2 = 1.0 - e2 * std::sin(latitude_rad) * std::sin(latitude_rad);
  const double w = std::sqrt(w2);
  return {kEquatorRadius_m * std::cos(latitude_rad) / w, kEquatorRadius_m * (1.0 - e2) / (w2 * w)};
}

}  // namespace

std::optional<glm::dvec2> longitude_latitude_deg(const SpatialReference& reference, glm::dvec2 place) {
  std::array<glm::dvec2, 1> at{place};
  if (!PlaceTransform(reference, SpatialReference::wgs84()).apply(at)) return std::nullopt;
  if (std::abs(at[0].y) > 90.0) return std::nullopt;
  return at[0];
}

glm::dvec2 ground_scale(const SpatialReference& reference, glm::dvec2 place) {
  constexpr double kStep_m = 100.0;
  const double unit_m = reference.metres_per_unit();
  const double step = kStep_m / unit_m;
  std::array<glm::dvec2, 3> at{place, place + glm::dvec2(step, 0.0), place + glm::dvec2(0.0, step)};
  if (!PlaceTransform(reference, SpatialReference::wgs84()).apply(at)) return {0.0, 0.0};
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  const glm::dvec2 per_radian_m = metres_per_radian(at[0].y * kRadPerDeg);
  const auto ground_m = [&](glm::dvec2 to) { return glm::length((to - at[0]) * kRadPerDeg * per_radian_m); };
  return {kStep_m / ground_m(at[1]), kStep_m / ground_m(at[2])};
}

}  // namespace prairie
