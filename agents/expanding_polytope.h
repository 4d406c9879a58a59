// How deep two convex shapes are in one another: the point of the boundary of A - B that is nearest to the
// origin, by the expanding polytope algorithm (van den Bergen 2001, Proximity Queries and Penetration Depth
// Computation on 3D Game Objects).
//
// Deviation: it does not start from GJK's last simplex but from a segment (D = 2) or triangle (D = 3) of far
// points, seen from both sides, so that flat and thin differences need no case of their own; the origin may
// be outside of it at first, faces then have negative distances. It tells depth and normal alone. Bounded by
// kMostVertices: the depth told always separates, and is the least one if `is_certain`.
//
// Where many vertices of A - B lie in one plane or on one line, as those of aligned boxes do, the farthest
// point of a direction is any of a side or an edge, and triangles between such points have no direction of
// their own. Two things keep them out: PolytopeRules::tie_break makes the polytope of corners alone, and
// an answer from slivers is not certain.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>

namespace prairie {

template <int D, typename Real>
struct Penetration {
  Real depth = 0;                     // negative: they do not overlap
  glm::vec<D, Real> normal{Real(0)};  // along which B moves out of A; a unit vector
  int iterations = 0;
  bool is_certain = false;
};

template <int D, typename Real>
struct PolytopeVertex {
  glm::vec<D, Real> point;
  std::uint64_t key = 0;
};

/// What the polytope is held to, in metres but for `tie_break`.
template <typename Real>
struct PolytopeRules {
  Real tolerance = 0;     // what rounding does to the points, and how well the depth is to be known
  Real tie_break = 0;     // of a direction, by which farthest points are sought beside it: a share
  Real least_height = 0;  // of a triangle whose plane is believed
};

/// The plane that a side of the polytope is on.
template <int D, typename Real>
struct PolytopeFace {
  glm::vec<D, Real> normal;
  Real distance;
};

template <int D, typename Real>
class ExpandingPolytope;

/// A convex polygon about the origin, counter-clockwise.
template <typename Real>
class ExpandingPolytope<2, Real> {
 public:
  using Vertex = PolytopeVertex<2, Real>;
  static constexpr int kMostVertices = 128;

  /// Whether it has grown.
  bool add(const Vertex& vertex, int face, Real) {
    if (count_ == kMostVertices) return false;
    for (int i = 0; i < count_; ++i) {
      if (vertices_[i].key == vertex.key) return false;
    }
    for (int i = count_; i > face + 1; --i) {
      vertices_[i] = vertices_[i - 1];
      normals_[i] = normals_[i - 1];
      distances_[i] = distances_[i - 1];
    }
    vertices_[face + 1] = vertex;
    ++count_;
    measure(face);
    measure(face + 1);
    return true;
  }
  /// From one vertex to the other and back.
  template <typename Farthest>
  void begin(const Vertex& from, const Vertex& to, const Farthest&, Real) {
    vertices_[0] = from;
    vertices_[1] = to;
    count_ = 2;
    measure(0);
    measure(1);
  }
  int nearest_face() const {
    int nearest = 0;
    for (int i = 1; i < count_; ++i) {
      if (distances_[i] < distances_[nearest]) nearest = i;
    }
    return nearest;
  }
  PolytopeFace<2, Real> face(int i) const { return {normals_[i], distances_[i]}; }
  bool has_sliver(Real) const { return false; }

 private:
  void measure(int i) {
    const glm::vec<2, Real> along = vertices_[(i + 1) % count_].point - vertices_[i].point;
    const Real length2 = glm::dot(along, along);
    normals_[i] = glm::vec<2, Real>(along.y, -along.x) / std::sqrt(length2);
    distances_[i] =
        length2 > Real(0) ? glm::dot(normals_[i], vertices_[i].point) : std::numeric_limits<Real>::max();
  }

  int count_ = 0;
  std::array<Vertex, kMostVertices> vertices_;
  std::array<glm::vec<2, Real>, kMostVertices> normals_;
  std::array<Real, kMostVertices> distances_;
};

/// A closed surface of triangles, counter-clockwise seen from outside. A new vertex replaces all triangles
/// that it sees by the cone over their border, so that the surface stays closed whatever rounding does to the
/// tests.
template <typename Real>
class ExpandingPolytope<3, Real> {
 public:
  using Vertex = PolytopeVertex<3, Real>;
  static constexpr int kMostVertices = 160;
  static constexpr int kMostFaces = 2 * kMostVertices;

  bool add(const Vertex& vertex, int, Real tolerance) {
    if (count_ == kMostVertices) return false;
    for (int i = 0; i < count_; ++i) {
      const glm::vec<3, Real> apart = vertices_[i].point - vertex.point;
      if (vertices_[i].key == vertex.key || glm::dot(apart, apart) <= tolerance * tolerance) return false;
    }
    int edge_count = 0, kept = 0;
    for (int f = 0; f < face_count_; ++f) {
      const Triangle face = faces_[f];
      if (!(glm::dot(face.normal, vertex.point) - face.distance > tolerance)) {
        faces_[kept++] = face;
        continue;
      }
      for (int side = 0; side < 3; ++side) {
        if (!toggle({face.vertices[side], face.vertices[(side + 1) % 3]}, edge_count)) return false;
      }
    }
    if (edge_count == 0 || kept + edge_count > kMostFaces) return false;
    face_count_ = kept;
    vertices_[count_] = vertex;
    for (int edge = 0; edge < edge_count; ++edge)
      put(edges_[edge][0], edges_[edge][1], static_cast<std::uint8_t>(count_));
    ++count_;
    return true;
  }
  /// A third vertex is sought aside of the two; on a line there is none, and the triangle is any through it.
  template <typename Farthest>
  void begin(const Vertex& from, const Vertex& to, const Farthest& farthest, Real tolerance) {
    const glm::vec<3, Real> along = glm::normalize(to.point - from.point);
    const glm::vec<3, Real> size = glm::abs(along);
    glm::vec<3, Real> axis(Real(0));
    axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = Real(1);
    const glm::vec<3, Real> side = glm::normalize(glm::cross(along, axis)), other = glm::cross(along, side);
    vertices_[0] = from;
    vertices_[1] = to;
    Real aside = Real(-1);
    glm::vec<3, Real> widest = side;
    for (const glm::vec<3, Real>& direction : {side, -side, other, -other}) {
      const Vertex vertex = farthest(direction);
      const glm::vec<3, Real> reach = vertex.point - from.point;
      const glm::vec<3, Real> away = reach - glm::dot(reach, along) * along;
      if (!(glm::dot(away, away) > aside)) continue;
      aside = glm::dot(away, away);
      widest = away;
      vertices_[2] = vertex;
    }
    count_ = 3;
    face_count_ = 0;
    put(0, 1, 2);
    put(1, 0, 2);
    const bool has_area = aside > tolerance * tolerance;
    const glm::vec<3, Real> normal = has_area ? glm::normalize(glm::cross(along, widest)) : side;
    for (int f = 0; f < 2; ++f) {
      faces_[f].normal = f == 0 ? normal : -normal;
      faces_[f].distance = glm::dot(faces_[f].normal, from.point);
    }
  }
  int nearest_face() const {
    int nearest = 0;
    for (int f = 1; f < face_count_; ++f) {
      if (faces_[f].distance < faces_[nearest].distance) nearest = f;
    }
    return nearest;
  }
  PolytopeFace<3, Real> face(int f) const { return {faces_[f].normal, faces_[f].distance}; }
  /// Whether some triangle is less high than that, so that rounding may have tilted its plane.
  bool has_sliver(Real least_height) const {
    for (int f = 0; f < face_count_; ++f) {
      const auto [i, j, k] = faces_[f].vertices;
      const glm::vec<3, Real>&a = vertices_[i].point, &b = vertices_[j].point, &c = vertices_[k].point;
      const glm::vec<3, Real> ab = b - a, ac = c - a, bc = c - b, normal = glm::cross(ab, ac);
      const Real longest2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
      if (!(glm::dot(normal, normal) >= least_height * least_height * longest2)) return true;
    }
    return false;
  }

 private:
  struct Triangle {
    glm::vec<3, Real> normal;
    Real distance;
    std::array<std::uint8_t, 3> vertices;
  };
  using Edge = std::array<std::uint8_t, 2>;

  /// An edge that two seen triangles share is not on their border.
  bool toggle(Edge edge, int& count) {
    for (int i = 0; i < count; ++i) {
      if (edges_[i][0] != edge[1] || edges_[i][1] != edge[0]) continue;
      edges_[i] = edges_[--count];
      return true;
    }
    if (count == kMostFaces) return false;
    edges_[count++] = edge;
    return true;
  }
  /// A triangle without an area is never nearest and never seen. The normal keeps to the longest side, about
  /// which alone rounding may turn it: on the thin sides of a needle that does no harm.
  void put(std::uint8_t i, std::uint8_t j, std::uint8_t k) {
    const glm::vec<3, Real>&a = vertices_[i].point, &b = vertices_[j].point, &c = vertices_[k].point;
    const glm::vec<3, Real> ab = b - a, ac = c - a, bc = c - b;
    const Real ab2 = glm::dot(ab, ab), ac2 = glm::dot(ac, ac), bc2 = glm::dot(bc, bc);
    const Real longest2 = std::max({ab2, ac2, bc2});
    const glm::vec<3, Real>& longest = ab2 == longest2 ? ab : ac2 == longest2 ? ac : bc;
    glm::vec<3, Real> normal = glm::cross(ab, ac);
    if (longest2 > Real(0)) normal -= (glm::dot(normal, longest) / longest2) * longest;
    const Real length = std::sqrt(glm::dot(normal, normal));
    const bool has_area = length > Real(0);
    Triangle& face = faces_[face_count_++];
    face.normal = has_area ? normal / length : glm::vec<3, Real>(Real(0));
    face.distance = has_area ? glm::dot(face.normal, a) : std::numeric_limits<Real>::max();
    face.vertices = {i, j, k};
  }

  int count_ = 0;
  int face_count_ = 0;
  std::array<Vertex, kMostVertices> vertices_;
  std::array<Triangle, kMostFaces> faces_;
  std::array<Edge, kMostFaces> edges_;
};

/// A direction near that one in which hardly anything has two farthest points.
template <int D, typename Real>
glm::vec<D, Real> beside(glm::vec<D, Real> direction, Real share) {
  constexpr Real kAnyWay[3] = {Real(0.8147), Real(-0.3711), Real(0.4459)};
  for (int axis = 0; axis < D; ++axis) direction[axis] += share * kAnyWay[axis];
  return direction;
}

/// `farthest(direction)` is the PolytopeVertex of A - B that is farthest along it.
template <int D, typename Real, typename Farthest>
Penetration<D, Real> penetration(const Farthest& farthest, const PolytopeRules<Real>& rules) {
  using Vector = glm::vec<D, Real>;
  using Vertex = PolytopeVertex<D, Real>;
  const Real tolerance = rules.tolerance;
  const auto corner = [&](const Vector& direction) { return farthest(beside(direction, rules.tie_break)); };
  Penetration<D, Real> best;

  Real widest = Real(-1);
  Vertex from, to;
  for (int axis = 0; axis < D; ++axis) {
    Vector direction(Real(0));
    direction[axis] = Real(1);
    const Vertex high = corner(direction), low = corner(-direction);
    const Real width = high.point[axis] - low.point[axis];
    if (!(width > widest)) continue;
    widest = width;
    from = low;
    to = high;
  }
  if (!(widest > tolerance)) {  // a point: any way out is as good
    best.normal[D - 1] = Real(1);
    best.depth = glm::dot(best.normal, from.point);
    best.is_certain = true;
    return best;
  }

  ExpandingPolytope<D, Real> polytope;
  polytope.begin(from, to, corner, tolerance);
  best.depth = std::numeric_limits<Real>::max();
  for (bool grows = true; grows;) {
    const int nearest = polytope.nearest_face();
    const auto [normal, distance] = polytope.face(nearest);
    const Vertex vertex = farthest(normal);
    const Real reach = glm::dot(normal, vertex.point);
    ++best.iterations;
    if (reach < best.depth) {
      best.depth = reach;
      best.normal = normal;
    }
    best.is_certain = best.depth - distance <= tolerance;
    const Real least_seen = Real(0.25) * tolerance;
    grows = !best.is_certain &&
            ((rules.tie_break > Real(0) && polytope.add(corner(normal), nearest, least_seen)) ||
             polytope.add(vertex, nearest, least_seen));
  }
  best.is_certain = best.is_certain && !polytope.has_sliver(rules.least_height);
  return best;
}

}  // namespace prairie
