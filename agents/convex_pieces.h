// A polygon, with holes or without, cut into convex pieces that agents/convex_shapes.h takes: how walls
// become obstacles.
//
// Constrained Delaunay triangles (CGAL, exact predicates) are merged across diagonals as long as the result
// is convex (Hertel & Mehlhorn 1983, Fast Triangulation of Simple Polygons), at most four times as many
// pieces as the fewest possible. CGAL's own partitions take polygons without holes only, and its
// decompositions of polygons with holes (vertical, Minkowski) make new points, which exact arithmetic has to
// round; here every corner of a piece is a point of the input, bit for bit, so that pieces neither overlap
// nor leave gaps.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace prairie {

/// Rings without self-crossings, in either direction; whether the last point repeats the first does not
/// matter, nor do other points repeated in succession.
struct WallPolygon {
  std::vector<glm::dvec2> outer_m;
  std::vector<std::vector<glm::dvec2>> holes_m;
};

/// Pieces counter-clockwise, without corners of 180 degrees, in an order that depends on the polygon alone.
/// Holes may touch the outer ring and one another at points.
///
/// Throws BadInput, the ring or point in `field`, on a ring that has fewer than 3 points or no area or that
/// crosses or touches itself, on a hole outside of the outer ring, crossing a ring, inside of another hole or
/// along an edge of a ring, on a number that is not finite, and on more than kMostPolygonPoints points in
/// all.
std::vector<std::vector<glm::dvec2>> convex_pieces(const WallPolygon& polygon);
inline constexpr std::size_t kMostPolygonPoints = 10'000;

}  // namespace prairie
