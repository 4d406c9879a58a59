// Solids that blades are bent out of (B11 §2.1): spheres, capsules and boxes. All are convex, so that the
// signed distance along a straight line has one minimum.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <variant>

namespace prairie {

struct Sphere {
  glm::dvec3 centre_m;
  double radius_m;
};

struct Capsule {
  glm::dvec3 from_m, to_m;  // the axis, to the middles of the hemispheres
  double radius_m;
};

struct Box {
  glm::dvec3 centre_m;
  glm::dmat3 axes;  // unit columns
  glm::dvec3 half_size_m;
};

using Solid = std::variant<Sphere, Capsule, Box>;

/// Where a point is to a solid's surface.
struct Separation {
  double distance_m;   // negative inside
  glm::dvec3 outward;  // unit vector along which the distance grows fastest
};

Separation separation(const Solid& solid, glm::dvec3 point_m);

}  // namespace prairie
