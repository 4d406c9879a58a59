// Solids that blades are bent out of (B11 §2.1): spheres, capsules and boxes. All are convex, so that the
// signed distance along a straight line has one minimum.
#pragma once

#include <glm/geometric.hpp>
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

// Of each shape, for those who ask for many points of one solid.

inline Separation separation(const Sphere& sphere, glm::dvec3 point_m) {
  constexpr double kPoint = 1e-12;
  const glm::dvec3 away = point_m - sphere.centre_m;
  const double distance_m = glm::length(away);
  return {distance_m - sphere.radius_m, distance_m > kPoint ? away / distance_m : glm::dvec3(0.0, 0.0, 1.0)};
}

Separation separation(const Capsule& capsule, glm::dvec3 point_m);
Separation separation(const Box& box, glm::dvec3 point_m);

}  // namespace prairie
