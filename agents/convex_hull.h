// The convex hull of points in space, in its own frame, ready for distances (agents/convex_shapes.h,
// PlacedHull): its vertices, which of them are adjacent, and its surface. By CGAL's quickhull with exact
// predicates, so that no rounding decides what is a vertex; vertices are points of the input, bit for bit, in
// an order that depends on them alone.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "agents/convex_shapes.h"

namespace prairie {

struct ConvexHull {
  std::vector<glm::dvec3> vertices_m;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
  // Adjacent vertices, ascending: of vertex v those from neighbours[first_neighbour[v]] to before those of v
  // + 1.
  std::vector<std::uint32_t> first_neighbour;
  std::vector<std::uint32_t> neighbours;
  double extent_m = 0.0;  // no vertex is farther from the frame's origin
};

/// Throws BadInput on fewer than 4 points or more than kMostHullPoints, on a number that is not finite, and
/// on points that all lie on one plane: such a hull has no inside. (Distances need none: ConvexVertices takes
/// any points.)
ConvexHull convex_hull(std::span<const glm::dvec3> points_m);
inline constexpr std::size_t kMostHullPoints = 1'000'000;

/// The hull as a shape, which refers to it.
PlacedHull<double> placed(const ConvexHull& hull, const glm::dvec3& origin_m, const glm::dmat3& axes);

}  // namespace prairie
