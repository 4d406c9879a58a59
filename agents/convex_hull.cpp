#include "agents/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <set>

#include "files/error.h"

namespace prairie {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

std::vector<Point> checked(std::span<const glm::dvec3> points_m) {
  if (points_m.size() < 4 || points_m.size() > kMostHullPoints) {
    throw BadInput("", "points", fmt::format("{} points", points_m.size()),
                   fmt::format("4 to {}", kMostHullPoints));
  }
  std::vector<Point> points;
  points.reserve(points_m.size());
  for (std::size_t n = 0; n < points_m.size(); ++n) {
    const glm::dvec3& point = points_m[n];
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
      throw BadInput("", fmt::format("points[{}]", n), fmt::format("({}, {}, {})", point.x, point.y, point.z),
                     "finite numbers");
    }
    points.emplace_back(point.x, point.y, point.z);
  }

  const Point& first = points[0];
  const auto second = std::ranges::find_if(points, [&](const Point& p) { return p != first; });
  if (second == points.end()) throw BadInput("", "points", "one point alone", "points not all on one plane");
  const auto third =
      std::ranges::find_if(points, [&](const Point& p) { return !CGAL::collinear(first, *second, p); });
  if (third == points.end())
    throw BadInput("", "points", "points on one line", "points not all on one plane");
  if (std::ranges::all_of(points, [&](const Point& p) { return CGAL::coplanar(first, *second, *third, p); }))
    throw BadInput("", "points", "points on one plane", "points not all on one plane");
  return points;
}

}  // namespace

ConvexHull convex_hull(std::span<const glm::dvec3> points_m) {
  const std::vector<Point> points = checked(points_m);
  std::vector<Point> corners;
  std::vector<std::array<std::uint32_t, 3>> faces;
  CGAL::convex_hull_3(points.begin(), points.end(), corners, faces);

  // CGAL's order depends on where things lie in memory.
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return corners[a] < corners[b]; });
  std::vector<std::uint32_t> place(corners.size());
  ConvexHull hull;
  hull.vertices_m.reserve(order.size());
  for (const std::uint32_t corner : order) {
    place[corner] = static_cast<std::uint32_t>(hull.vertices_m.size());
    const Point& point = corners[corner];
    hull.vertices_m.emplace_back(point.x(), point.y(), point.z());
    hull.extent_m = std::max(hull.extent_m, glm::length(hull.vertices_m.back()));
  }
  std::vector<std::set<std::uint32_t>> adjacent(hull.vertices_m.size());
  for (std::array<std::uint32_t, 3> triangle : faces) {
    for (std::uint32_t& corner : triangle) corner = place[corner];
    std::ranges::rotate(triangle, std::ranges::min_element(triangle));
    hull.triangles.push_back(triangle);
    for (std::size_t from = 0; from < 3; ++from) {
      adjacent[triangle[from]].insert(triangle[(from + 1) % 3]);
      adjacent[triangle[from]].insert(triangle[(from + 2) % 3]);
    }
  }
  std::ranges::sort(hull.triangles);
  for (const std::set<std::uint32_t>& neighbours : adjacent) {
    hull.first_neighbour.push_back(static_cast<std::uint32_t>(hull.neighbours.size()));
    hull.neighbours.insert(hull.neighbours.end(), neighbours.begin(), neighbours.end());
  }
  hull.first_neighbour.push_back(static_cast<std::uint32_t>(hull.neighbours.size()));
  return hull;
}

PlacedHull<double> placed(const ConvexHull& hull, const glm::dvec3& origin_m, const glm::dmat3& axes) {
  return {.vertices_m = hull.vertices_m,
          .extent_m = hull.extent_m,
          .first_neighbour = hull.first_neighbour,
          .neighbours = hull.neighbours,
          .origin_m = origin_m,
          .axes = axes};
}

}  // namespace prairie
