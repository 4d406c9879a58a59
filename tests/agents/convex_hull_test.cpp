#include "agents/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "files/error.h"
#include "tests/agents/convex_cases.h"

namespace prairie {
namespace {

using testing::Draw;
using testing::Points;

/// How far the points reach out of the hull's surface.
double beyond(const ConvexHull& hull, const Points& points) {
  double most = -1e300;
  for (const auto& triangle : hull.triangles) {
    const glm::dvec3 corner = hull.vertices_m[triangle[0]];
    const glm::dvec3 normal = glm::normalize(
        glm::cross(hull.vertices_m[triangle[1]] - corner, hull.vertices_m[triangle[2]] - corner));
    for (const glm::dvec3& point : points) most = std::max(most, glm::dot(normal, point - corner));
  }
  return most;
}

TEST(ConvexHull, HoldsItsPointsInAClosedSurface) {
  Draw draw(1);
  for (int n = 0; n < 100; ++n) {
    const Points points = testing::cloud(draw, 4 + draw.below(200), {1.0, 2.0, 0.5});
    const ConvexHull hull = convex_hull(points);
    EXPECT_LT(beyond(hull, points), 1e-12);
    EXPECT_EQ(hull.triangles.size(), 2 * hull.vertices_m.size() - 4);
    for (const glm::dvec3& vertex : hull.vertices_m)
      EXPECT_NE(std::ranges::find(points, vertex), points.end());
  }
}

TEST(ConvexHull, NeighboursAreThoseOfItsTriangles) {
  Draw draw(2);
  const ConvexHull hull = convex_hull(testing::cloud(draw, 100, glm::dvec3(1.0)));
  ASSERT_EQ(hull.first_neighbour.size(), hull.vertices_m.size() + 1);
  ASSERT_EQ(hull.neighbours.size(), 3 * hull.triangles.size());
  const auto are_neighbours = [&](std::uint32_t from, std::uint32_t to) {
    const auto begin = hull.neighbours.begin() + hull.first_neighbour[from];
    const auto end = hull.neighbours.begin() + hull.first_neighbour[from + 1];
    return std::find(begin, end, to) != end;
  };
  for (const auto& triangle : hull.triangles) {
    for (std::size_t side = 0; side < 3; ++side) {
      EXPECT_TRUE(are_neighbours(triangle[side], triangle[(side + 1) % 3]));
      EXPECT_TRUE(are_neighbours(triangle[(side + 1) % 3], triangle[side]));
    }
  }
}

TEST(ConvexHull, OfAGridIsItsCube) {
  Points points;
  for (int n = 0; n < 125; ++n) points.push_back({n % 5, n / 5 % 5, n / 25});
  const ConvexHull hull = convex_hull(points);
  EXPECT_LT(beyond(hull, points), 1e-12);
  EXPECT_DOUBLE_EQ(hull.extent_m, std::sqrt(48.0));
  for (const glm::dvec3& corner : {glm::dvec3(0.0), glm::dvec3(4.0), glm::dvec3(4.0, 0.0, 4.0)})
    EXPECT_NE(std::ranges::find(hull.vertices_m, corner), hull.vertices_m.end());
}

std::string found_in(const Points& points) {
  try {
    convex_hull(points);
  } catch (const BadInput& fault) {
    return fault.field + ": " + fault.found;
  }
  return "";
}

TEST(ConvexHull, RefusesWhatHasNoInside) {
  EXPECT_EQ(found_in({}), "points: 0 points");
  EXPECT_EQ(found_in(Points(9, {1.0, 2.0, 3.0})), "points: one point alone");
  Points line, plane;
  for (int n = 0; n < 9; ++n) {
    line.push_back(static_cast<double>(n) * glm::dvec3(1.0, 2.0, 4.0));
    plane.push_back({n % 3, n / 3, n % 3 + n / 3});
  }
  EXPECT_EQ(found_in(line), "points: points on one line");
  EXPECT_EQ(found_in(plane), "points: points on one plane");
  plane.push_back({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  EXPECT_EQ(found_in(plane), "points[9]: (nan, 0, 0)");
}

}  // namespace
}  // namespace prairie
