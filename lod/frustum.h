// The part of space that a camera sees, as planes through which boxes are tested (RG, "View Frustum
// Culling").
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "lod/camera.h"

namespace prairie {

/// An axis-aligned box in the scene, metres.
struct AlignedBox {
  glm::dvec3 min_m;
  glm::dvec3 max_m;
};

class Frustum {
 public:
  explicit Frustum(const Camera& camera);

  /// False only if no point of the box is seen.
  bool may_see(const AlignedBox& box) const;

 private:
  // Points p inside satisfy normal · (p − eye) + offset ≥ 0.
  struct Plane {
    glm::dvec3 normal;
    double offset;
  };
  glm::dvec3 eye_m_;
  std::array<Plane, 5> planes_;  // near and the four sides; the far plane is at infinity
};

/// Distance from a point to the nearest point of a box, metres.
double nearest_distance_m(const AlignedBox& box, glm::dvec3 point_m);

}  // namespace prairie
