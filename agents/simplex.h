// The point of a simplex that is nearest to the origin: the inner step of GJK. Its barycentric coordinates
// are ratios of signed volumes, as in the signed-volumes method of Montanari, Petrinic & Barbieri 2017,
// Improving the GJK Algorithm for Faster and More Reliable Distance Queries Between Two Convex Objects (ACM
// TOG 36(3)).
//
// Deviations: cofactors come from cross products and are not projected onto a coordinate plane first, which
// saves branches; where the nearest point is inside a triangle, it is taken along the triangle's normal,
// which keeps the direction of a short distance; a volume that is all rounding makes all faces candidates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace prairie {

/// Vertices of the Minkowski difference A - B, each known by its support points' indices in A and B.
template <int D, typename Real>
struct Simplex {
  int count = 0;
  std::array<glm::vec<D, Real>, D + 1> points;
  std::array<glm::vec<D, Real>, D + 1> on_a;  // the support points in A
  std::array<std::uint64_t, D + 1> keys;      // index in A << 32 | index in B
  std::array<Real, D + 1> weights;            // of the nearest point; positive, their sum is 1
};

/// Where the nearest point is: in the face of these vertices.
template <int D, typename Real>
struct SimplexFace {
  glm::vec<D, Real> nearest{Real(0)};
  Real squared = std::numeric_limits<Real>::max();  // its distance's square
  int count = 0;
  std::array<std::uint8_t, D + 1> vertices{};
  std::array<Real, D + 1> weights{};
};

template <int D, typename Real>
SimplexFace<D, Real> nearest_of_point(const Simplex<D, Real>& simplex, int i) {
  SimplexFace<D, Real> face;
  face.nearest = simplex.points[i];
  face.squared = glm::dot(face.nearest, face.nearest);
  face.count = 1;
  face.vertices[0] = static_cast<std::uint8_t>(i);
  face.weights[0] = Real(1);
  return face;
}

template <int D, typename Real>
SimplexFace<D, Real> nearest_on_segment(const Simplex<D, Real>& simplex, int i, int j) {
  const glm::vec<D, Real>& a = simplex.points[i];
  const glm::vec<D, Real> edge = simplex.points[j] - a;
  const Real along = -glm::dot(a, edge);
  if (!(along > Real(0))) return nearest_of_point(simplex, i);
  const Real length2 = glm::dot(edge, edge);
  if (!(along < length2)) return nearest_of_point(simplex, j);
  SimplexFace<D, Real> face;
  const Real share = along / length2;
  face.nearest = a + share * edge;
  face.squared = glm::dot(face.nearest, face.nearest);
  face.count = 2;
  face.vertices[0] = static_cast<std::uint8_t>(i);
  face.vertices[1] = static_cast<std::uint8_t>(j);
  face.weights[0] = Real(1) - share;
  face.weights[1] = share;
  return face;
}

template <int D, typename Real>
void take_nearer(SimplexFace<D, Real>& best, const SimplexFace<D, Real>& other) {
  if (other.squared < best.squared) best = other;
}

/// The parallelogram's signed area.
template <typename Real>
Real cross_of(const glm::vec<2, Real>& a, const glm::vec<2, Real>& b) {
  return a.x * b.y - a.y * b.x;
}

/// In the plane a triangle that holds the origin is nearest with all three vertices, at distance 0.
template <typename Real>
SimplexFace<2, Real> nearest_on_triangle(const Simplex<2, Real>& simplex, int i, int j, int k) {
  const glm::vec<2, Real>&a = simplex.points[i], &b = simplex.points[j], &c = simplex.points[k];
  const Real area = cross_of(b - a, c - a);
  const Real sign = area < Real(0) ? Real(-1) : Real(1);
  const Real of_a = sign * cross_of(b, c), of_b = sign * cross_of(c, a), of_c = sign * cross_of(a, b);
  SimplexFace<2, Real> face;
  const bool is_inside = of_a > Real(0) && of_b > Real(0) && of_c > Real(0);
  if (is_inside) {
    const Real sum = of_a + of_b + of_c;
    face.squared = Real(0);
    face.count = 3;
    face.vertices = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
                     static_cast<std::uint8_t>(k)};
    face.weights = {of_a / sum, of_b / sum, of_c / sum};
    return face;
  }
  if (!(of_a > Real(0))) take_nearer(face, nearest_on_segment(simplex, j, k));
  if (!(of_b > Real(0))) take_nearer(face, nearest_on_segment(simplex, i, k));
  if (!(of_c > Real(0))) take_nearer(face, nearest_on_segment(simplex, i, j));
  return face;
}

template <typename Real>
SimplexFace<3, Real> nearest_on_triangle(const Simplex<3, Real>& simplex, int i, int j, int k) {
  const glm::vec<3, Real>&a = simplex.points[i], &b = simplex.points[j], &c = simplex.points[k];
  const glm::vec<3, Real> normal = glm::cross(b - a, c - a);
  const Real of_a = glm::dot(normal, glm::cross(b, c)), of_b = glm::dot(normal, glm::cross(c, a)),
             of_c = glm::dot(normal, glm::cross(a, b));
  SimplexFace<3, Real> face;
  if (of_a > Real(0) && of_b > Real(0) && of_c > Real(0)) {
    const Real height = glm::dot(normal, a);
    const Real share = height / glm::dot(normal, normal);
    const Real per_sum = Real(1) / (of_a + of_b + of_c);
    face.nearest = share * normal;
    face.squared = share * height;
    face.count = 3;
    face.vertices = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j), static_cast<std::uint8_t>(k),
                     0};
    face.weights = {of_a * per_sum, of_b * per_sum, of_c * per_sum, Real(0)};
    return face;
  }
  if (!(of_a > Real(0))) take_nearer(face, nearest_on_segment(simplex, j, k));
  if (!(of_b > Real(0))) take_nearer(face, nearest_on_segment(simplex, i, k));
  if (!(of_c > Real(0))) take_nearer(face, nearest_on_segment(simplex, i, j));
  return face;
}

/// With all four vertices, at distance 0, if the tetrahedron holds the origin.
template <typename Real>
SimplexFace<3, Real> nearest_on_tetrahedron(const Simplex<3, Real>& simplex) {
  const glm::vec<3, Real>&a = simplex.points[0], &b = simplex.points[1], &c = simplex.points[2],
                    &d = simplex.points[3];
  const glm::vec<3, Real> cd = glm::cross(c, d), ab = glm::cross(a, b);
  const std::array<Real, 4> of = {glm::dot(b, cd), -glm::dot(a, cd), glm::dot(ab, d), -glm::dot(ab, c)};
  const Real volume = of[0] + of[1] + of[2] + of[3];
  const Real reach2 =
      std::max(std::max(glm::dot(a, a), glm::dot(b, b)), std::max(glm::dot(c, c), glm::dot(d, d)));
  const Real noise = Real(16) * std::numeric_limits<Real>::epsilon() * reach2 * std::sqrt(reach2);
  const bool is_flat = !(volume > noise) && !(volume < -noise);
  const Real sign = volume < Real(0) ? Real(-1) : Real(1);

  SimplexFace<3, Real> face;
  if (!is_flat && sign * of[0] > Real(0) && sign * of[1] > Real(0) && sign * of[2] > Real(0) &&
      sign * of[3] > Real(0)) {
    face.squared = Real(0);
    face.count = 4;
    face.vertices = {0, 1, 2, 3};
    for (int i = 0; i < 4; ++i) face.weights[i] = of[i] / volume;
    return face;
  }
  if (is_flat || !(sign * of[0] > Real(0))) take_nearer(face, nearest_on_triangle(simplex, 1, 2, 3));
  if (is_flat || !(sign * of[1] > Real(0))) take_nearer(face, nearest_on_triangle(simplex, 0, 2, 3));
  if (is_flat || !(sign * of[2] > Real(0))) take_nearer(face, nearest_on_triangle(simplex, 0, 1, 3));
  if (is_flat || !(sign * of[3] > Real(0))) take_nearer(face, nearest_on_triangle(simplex, 0, 1, 2));
  return face;
}

/// Of a simplex of 1 to D + 1 vertices.
template <int D, typename Real>
SimplexFace<D, Real> nearest_to_origin(const Simplex<D, Real>& simplex) {
  if (simplex.count == 1) return nearest_of_point(simplex, 0);
  if (simplex.count == 2) return nearest_on_segment(simplex, 0, 1);
  if constexpr (D == 3) {
    if (simplex.count == 4) return nearest_on_tetrahedron(simplex);
  }
  return nearest_on_triangle(simplex, 0, 1, 2);
}

/// Keeps the face's vertices alone, in their order.
template <int D, typename Real>
void reduce(Simplex<D, Real>& simplex, const SimplexFace<D, Real>& face) {
  for (int i = 0; i < face.count; ++i) {
    simplex.points[i] = simplex.points[face.vertices[i]];
    simplex.on_a[i] = simplex.on_a[face.vertices[i]];
    simplex.keys[i] = simplex.keys[face.vertices[i]];
    simplex.weights[i] = face.weights[i];
  }
  simplex.count = face.count;
}

}  // namespace prairie
