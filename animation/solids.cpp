#include "animation/solids.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace prairie {
namespace {

constexpr double kPoint = 1e-12;

}  // namespace

Separation separation(const Capsule& capsule, glm::dvec3 point_m) {
  const glm::dvec3 axis = capsule.to_m - capsule.from_m;
  const double length2 = glm::dot(axis, axis);
  const double along = length2 > kPoint ? glm::dot(point_m - capsule.from_m, axis) / length2 : 0.0;
  return separation(Sphere{capsule.from_m + axis * std::clamp(along, 0.0, 1.0), capsule.radius_m}, point_m);
}

Separation separation(const Box& box, glm::dvec3 point_m) {
  const glm::dvec3 local = (point_m - box.centre_m) * box.axes;  // by the transposed matrix
  const glm::dvec3 over = glm::abs(local) - box.half_size_m;
  const glm::dvec3 outside = glm::max(over, glm::dvec3(0.0));
  const double distance_m = glm::length(outside);
  const glm::dvec3 sign(local.x < 0.0 ? -1.0 : 1.0, local.y < 0.0 ? -1.0 : 1.0, local.z < 0.0 ? -1.0 : 1.0);
  if (distance_m > kPoint) return {distance_m, box.axes * (outside / distance_m * sign)};
  const int face = over.x > over.y ? (over.x > over.z ? 0 : 2) : (over.y > over.z ? 1 : 2);
  return {over[face], box.axes[face] * sign[face]};
}

Separation separation(const Solid& solid, glm::dvec3 point_m) {
  return std::visit([&](const auto& shape) { return separation(shape, point_m); }, solid);
}

}  // namespace prairie
