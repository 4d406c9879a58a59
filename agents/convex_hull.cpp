#include "agents/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "files/error.h"

namespace prairie {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

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
  Mesh mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), mesh);

  // CGAL's order depends on where things lie in memory.
  std::vector<Mesh::Vertex_index> order(mesh.vertices().begin(), mesh.vertices().end());
  std::ranges::sort(
      order, [&](Mesh::Vertex_index a, Mesh::Vertex_index b) { return mesh.point(a) < mesh.point(b); });
  std::vector<std::uint32_t> place(mesh.num_vertices());
  ConvexHull hull;
  hull.vertices_m.reserve(order.size());
  for (const Mesh::Vertex_index vertex : order) {
    place[vertex.idx()] = static_cast<std::uint32_t>(hull.vertices_m.size());
    const Point& point = mesh.point(vertex);
    hull.vertices_m.emplace_back(point.x(), point.y(), point.z());
    hull.extent_m = std::max(hull.extent_m, glm::length(hull.vertices_m.back()));
  }
  std::vector<std::set<std::uint32_t>> adjacent(hull.vertices_m.size());
  for (const Mesh::Face_index face : mesh.faces()) {
    std::array<std::uint32_t, 3> triangle{};
    std::size_t corner = 0;
    for (const Mesh::Vertex_index vertex : mesh.vertices_around_face(mesh.halfedge(face)))
      triangle.at(corner++) = place[vertex.idx()];
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
