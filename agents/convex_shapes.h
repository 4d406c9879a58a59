// Convex shapes in the plane (D = 2) and in space (D = 3) whose distance agents/gjk.h tells, in float or
// double. A round shape is a core, a point or a segment, and a radius about it: distances are taken between
// cores, whose support functions are exact, and the radii are subtracted (van den Bergen 2003, Collision
// Detection in Interactive 3D Environments, ch. 4). Shapes are plain data and own nothing; metres.
#pragma once

#include <cstdint>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace prairie {

/// All points within `radius_m` of a point, which is a shape, too: radius 0. A circle's disc in the plane.
template <int D, typename Real>
struct SphereShape {
  glm::vec<D, Real> centre_m{Real(0)};
  Real radius_m = 0;
};

/// All points within `radius_m` of a segment; its ends may be one point, its radius may be 0.
template <int D, typename Real>
struct CapsuleShape {
  glm::vec<D, Real> from_m{Real(0)};
  glm::vec<D, Real> to_m{Real(0)};
  Real radius_m = 0;
};

/// `axes` has orthonormal columns (taken as they are: others make a parallelepiped); extents are 0 or more.
template <int D, typename Real>
struct BoxShape {
  glm::vec<D, Real> centre_m{Real(0)};
  glm::mat<D, D, Real> axes{Real(1)};
  glm::vec<D, Real> half_extents_m{Real(0)};
};

/// The convex hull of at least one point, where they stand; points inside cost time alone. Two-dimensional,
/// it is a convex polygon, in whichever order its vertices come. Support is a scan over all of them.
template <int D, typename Real>
struct ConvexVertices {
  std::span<const glm::vec<D, Real>> vertices_m;
};

/// A hull in a frame of its own (agents/convex_hull.h makes one) that stands at `origin_m`, turned by `axes`.
/// With the lists of adjacent vertices support climbs from vertex to vertex; without them it scans.
template <typename Real>
struct PlacedHull {
  std::span<const glm::vec<3, Real>> vertices_m;
  Real extent_m = 0;                               // no vertex is farther from the frame's origin
  std::span<const std::uint32_t> first_neighbour;  // of each vertex in `neighbours`, and one past the last
  std::span<const std::uint32_t> neighbours;
  glm::vec<3, Real> origin_m{Real(0)};
  glm::mat<3, 3, Real> axes{Real(1)};
};

}  // namespace prairie
