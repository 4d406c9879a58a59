#include "lod/frustum.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace prairie {

Frustum::Frustum(const Camera& camera) : eye_m_(camera.eye_m) {
  const glm::dvec3 right = camera.right();
  const glm::dvec3 up = camera.up();
  const glm::dvec3 forward = camera.forward();
  const double aspect = static_cast<double>(camera.size_px.x) / camera.size_px.y;
  if (camera.is_orthographic()) {
    const double half_m = 0.5 * camera.orthographic_height_m;
    planes_ = {Plane{forward, 0.0}, Plane{right, half_m * aspect}, Plane{-right, half_m * aspect},
               Plane{up, half_m}, Plane{-up, half_m}};
  } else {
    const double half = std::tan(0.5 * camera.fov_rad);
    planes_ = {Plane{forward, -camera.near_m}, Plane{glm::normalize(forward * (half * aspect) + right), 0.0},
               Plane{glm::normalize(forward * (half * aspect) - right), 0.0},
               Plane{glm::normalize(forward * half + up), 0.0},
               Plane{glm::normalize(forward * half - up), 0.0}};
  }
}

bool Frustum::may_see(const AlignedBox& box) const {
  return std::all_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
    const glm::dvec3 foremost(plane.normal.x >= 0.0 ? box.max_m.x : box.min_m.x,
                              plane.normal.y >= 0.0 ? box.max_m.y : box.min_m.y,
                              plane.normal.z >= 0.0 ? box.max_m.z : box.min_m.z);
    return glm::dot(plane.normal, foremost - eye_m_) + plane.offset >= 0.0;
  });
}

double nearest_distance_m(const AlignedBox& box, glm::dvec3 point_m) {
  return glm::length(point_m - glm::clamp(point_m, box.min_m, box.max_m));
}

}  // namespace prairie
