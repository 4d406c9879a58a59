#include "agents/convex_pieces.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "files/error.h"

namespace prairie {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Ring = std::vector<Point>;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;  // place in the input
using InfoFaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;  // rings crossed from outside
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, InfoFaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

constexpr const char* kRingExpected =
    "a ring of at least 3 different points that encloses an area and does not cross itself";
constexpr const char* kHoleExpected = "holes inside the outer ring that neither cross nor hold one another";

/// Without repetitions.
Ring checked_ring(const std::vector<glm::dvec2>& points_m, const std::string& field) {
  Ring ring;
  for (std::size_t n = 0; n < points_m.size(); ++n) {
    const glm::dvec2& at_m = points_m[n];
    if (!std::isfinite(at_m.x) || !std::isfinite(at_m.y)) {
      throw BadInput("", fmt::format("{}[{}]", field, n), fmt::format("({}, {})", at_m.x, at_m.y),
                     "finite numbers");
    }
    const Point point(at_m.x, at_m.y);
    if (ring.empty() || ring.back() != point) ring.push_back(point);
  }
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  if (ring.size() < 3)
    throw BadInput("", field, fmt::format("{} different points", ring.size()), kRingExpected);
  const bool is_line =
      std::ranges::all_of(ring, [&](const Point& p) { return CGAL::collinear(ring[0], ring[1], p); });
  if (is_line) throw BadInput("", field, "points on one line, which have no area", kRingExpected);
  if (!CGAL::is_simple_2(ring.begin(), ring.end(), Kernel()))
    throw BadInput("", field, "a ring that crosses or touches itself", kRingExpected);
  return ring;
}

/// Relative to its first point, which is what keeps small rings far from the origin exact enough.
double area_m2(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t n = 1; n + 1 < ring.size(); ++n) {
    twice += (ring[n].x() - ring[0].x()) * (ring[n + 1].y() - ring[0].y()) -
             (ring[n + 1].x() - ring[0].x()) * (ring[n].y() - ring[0].y());
  }
  return 0.5 * std::abs(twice);
}

std::vector<Ring> checked_rings(const WallPolygon& polygon) {
  std::size_t count = polygon.outer_m.size();
  for (const auto& hole_m : polygon.holes_m) count += hole_m.size();
  if (count > kMostPolygonPoints)
    throw BadInput("", "polygon", fmt::format("{} points", count),
                   fmt::format("at most {}", kMostPolygonPoints));

  std::vector<Ring> rings = {checked_ring(polygon.outer_m, "outer")};
  for (std::size_t hole = 0; hole < polygon.holes_m.size(); ++hole)
    rings.push_back(checked_ring(polygon.holes_m[hole], fmt::format("holes[{}]", hole)));
  for (std::size_t hole = 1; hole < rings.size(); ++hole) {
    for (const Point& point : rings[hole]) {
      if (CGAL::bounded_side_2(rings[0].begin(), rings[0].end(), point, Kernel()) ==
          CGAL::ON_UNBOUNDED_SIDE) {
        throw BadInput("", fmt::format("holes[{}]", hole - 1),
                       fmt::format("({}, {}) outside of the outer ring", point.x(), point.y()),
                       kHoleExpected);
      }
    }
  }
  return rings;
}

void insert_rings(Triangulation& triangulation, const std::vector<Ring>& rings) {
  int first = 0;
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    std::vector<Triangulation::Vertex_handle> handles;
    for (std::size_t n = 0; n < rings[ring].size(); ++n) {
      handles.push_back(triangulation.insert(rings[ring][n]));
      handles.back()->info() = first + static_cast<int>(n);
    }
    first += static_cast<int>(rings[ring].size());
    try {
      for (std::size_t n = 0; n < handles.size(); ++n)
        triangulation.insert_constraint(handles[n], handles[(n + 1) % handles.size()]);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      throw BadInput("", fmt::format("holes[{}]", ring - 1), "a hole that crosses another ring",
                     kHoleExpected);
    }
  }
}

/// How many rings are crossed on the way from outside: 1 inside of the polygon.
void count_crossings(Triangulation& triangulation) {
  for (const auto face : triangulation.all_face_handles()) face->info() = -1;
  std::vector<Triangulation::Face_handle> level = {triangulation.infinite_face()};
  for (int crossed = 0; !level.empty(); ++crossed) {
    std::vector<Triangulation::Face_handle> beyond;
    while (!level.empty()) {
      const Triangulation::Face_handle face = level.back();
      level.pop_back();
      if (face->info() != -1) continue;
      face->info() = crossed;
      for (int side = 0; side < 3; ++side) {
        const Triangulation::Face_handle next = face->neighbor(side);
        if (next->info() == -1) (face->is_constrained(side) ? beyond : level).push_back(next);
      }
    }
    level = std::move(beyond);
  }
}

/// Pieces by the places of their corners in the input, counter-clockwise.
using Corners = std::vector<int>;

std::vector<Corners> triangles_inside(Triangulation& triangulation) {
  std::vector<Corners> triangles;
  for (const auto face : triangulation.finite_face_handles()) {
    if (face->info() != 1) continue;
    Corners corners = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    triangles.push_back(std::move(corners));
  }
  std::ranges::sort(triangles);
  return triangles;
}

struct Diagonal {
  double length2 = 0.0;
  int from = 0, to = 0;             // from < to
  std::size_t left = 0, right = 0;  // triangles beside it
};

/// The longest first.
std::vector<Diagonal> diagonals_between(const std::vector<Corners>& triangles,
                                        const std::vector<Point>& points) {
  std::vector<std::tuple<int, int, bool, std::size_t>> sides;
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int from = triangles[n][corner], to = triangles[n][(corner + 1) % 3];
      sides.emplace_back(std::min(from, to), std::max(from, to), from > to, n);
    }
  }
  std::ranges::sort(sides);
  std::vector<Diagonal> diagonals;
  for (std::size_t n = 0; n + 1 < sides.size(); ++n) {
    const auto [from, to, is_back, left] = sides[n];
    const auto [next_from, next_to, next_is_back, right] = sides[n + 1];
    if (from != next_from || to != next_to) continue;
    diagonals.push_back({CGAL::squared_distance(points[from], points[to]), from, to, left, right});
  }
  std::ranges::stable_sort(diagonals, std::greater<>(), &Diagonal::length2);
  return diagonals;
}

/// Whether the way a, b, c goes straight on or turns left at b.
bool is_convex_corner(const Point& a, const Point& b, const Point& c) {
  const CGAL::Orientation turn = CGAL::orientation(a, b, c);
  return turn == CGAL::LEFT_TURN || (turn == CGAL::COLLINEAR && CGAL::angle(a, b, c) == CGAL::OBTUSE);
}

/// Both pieces without their common side; empty if that is not convex.
Corners merged(Corners left, Corners right, const Diagonal& diagonal, const std::vector<Point>& points) {
  std::rotate(left.begin(), std::ranges::find(left, diagonal.to), left.end());       // to … from
  std::rotate(right.begin(), std::ranges::find(right, diagonal.from), right.end());  // from … to
  const auto point = [&](int corner) -> const Point& { return points[static_cast<std::size_t>(corner)]; };
  if (!is_convex_corner(point(left[left.size() - 2]), point(diagonal.from), point(right[1])) ||
      !is_convex_corner(point(right[right.size() - 2]), point(diagonal.to), point(left[1])))
    return {};
  left.insert(left.end(), right.begin() + 1, right.end() - 1);
  return left;
}

std::vector<Corners> merged_pieces(std::vector<Corners> pieces, const std::vector<Diagonal>& diagonals,
                                   const std::vector<Point>& points) {
  std::vector<std::size_t> into(pieces.size());  // what a piece has become part of; itself if it is whole
  std::iota(into.begin(), into.end(), std::size_t{0});
  const auto whole = [&](std::size_t piece) {
    while (into[piece] != piece) piece = into[piece] = into[into[piece]];
    return piece;
  };
  for (const Diagonal& diagonal : diagonals) {
    const std::size_t left = whole(diagonal.left), right = whole(diagonal.right);
    if (left == right) continue;
    Corners both = merged(pieces[left], pieces[right], diagonal, points);
    if (both.empty()) continue;
    pieces[left] = std::move(both);
    pieces[right].clear();
    into[right] = left;
  }
  std::erase_if(pieces, [](const Corners& corners) { return corners.empty(); });
  return pieces;
}

}  // namespace

std::vector<std::vector<glm::dvec2>> convex_pieces(const WallPolygon& polygon) {
  const std::vector<Ring> rings = checked_rings(polygon);
  std::vector<Point> points;
  for (const Ring& ring : rings) points.insert(points.end(), ring.begin(), ring.end());

  Triangulation triangulation;
  insert_rings(triangulation, rings);
  count_crossings(triangulation);
  const std::vector<Corners> triangles = triangles_inside(triangulation);

  double expected_m2 = area_m2(rings[0]), found_m2 = 0.0;
  for (std::size_t hole = 1; hole < rings.size(); ++hole) expected_m2 -= area_m2(rings[hole]);
  for (const Corners& corners : triangles)
    found_m2 += area_m2({points[corners[0]], points[corners[1]], points[corners[2]]});
  if (triangles.empty() || std::abs(found_m2 - expected_m2) > 1e-9 * area_m2(rings[0])) {
    throw BadInput("", "holes",
                   fmt::format("{} m2 inside of the rings where their areas make {}", found_m2, expected_m2),
                   kHoleExpected);
  }

  std::vector<std::vector<glm::dvec2>> pieces;
  for (const Corners& corners : merged_pieces(triangles, diagonals_between(triangles, points), points)) {
    std::vector<glm::dvec2>& piece = pieces.emplace_back();
    for (std::size_t n = 0; n < corners.size(); ++n) {
      const Point& before = points[corners[(n + corners.size() - 1) % corners.size()]];
      const Point& at = points[corners[n]];
      if (!CGAL::collinear(before, at, points[corners[(n + 1) % corners.size()]]))
        piece.emplace_back(at.x(), at.y());
    }
  }
  return pieces;
}

}  // namespace prairie
