// What agents/gjk.h asks of the shapes of agents/convex_shapes.h: cores, relative to an origin near them, in
// the precision of the query. `support` is the farthest point along a direction of any length, with the
// number by which `point` finds it again in the same shape; `extent` bounds the size of all coordinates.
#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>

#include "agents/convex_shapes.h"

namespace prairie {

/// The number of vertices from which on climbing is faster than a scan.
inline constexpr std::size_t kLeastClimbedVertices = 48;

template <int D, typename Real>
struct SupportPoint {
  glm::vec<D, Real> point;
  std::uint32_t index;
};

// glm::abs compiles to branches, which half of the time are guessed wrong.
template <int D, typename Real>
glm::vec<D, Real> size_of(glm::vec<D, Real> vector) {
  for (int axis = 0; axis < D; ++axis) vector[axis] = std::abs(vector[axis]);
  return vector;
}
template <int D, typename Real>
Real largest_of(const glm::vec<D, Real>& size) {
  Real largest = size[0];
  for (int axis = 1; axis < D; ++axis) largest = size[axis] > largest ? size[axis] : largest;
  return largest;
}

template <int D, typename Real>
struct PointCore {
  glm::vec<D, Real> centre;

  SupportPoint<D, Real> support(const glm::vec<D, Real>&) const { return {centre, 0}; }
  glm::vec<D, Real> point(std::uint32_t) const { return centre; }
  Real extent() const { return largest_of(size_of(centre)); }
};

template <int D, typename Real>
struct SegmentCore {
  glm::vec<D, Real> centre;
  glm::vec<D, Real> from;
  glm::vec<D, Real> to;

  SupportPoint<D, Real> support(const glm::vec<D, Real>& direction) const {
    const std::uint32_t index = glm::dot(direction, to - from) > Real(0) ? 1 : 0;
    return {point(index), index};
  }
  glm::vec<D, Real> point(std::uint32_t index) const { return (index & 1) != 0 ? to : from; }
  Real extent() const { return largest_of(glm::max(size_of(from), size_of(to))); }
};

/// Vertices are numbered by the signs of the half axes, bit i for axis i, set where it is subtracted.
template <int D, typename Real>
struct BoxCore {
  glm::vec<D, Real> centre;
  glm::mat<D, D, Real> half_axes;
  Real half_diagonal;

  SupportPoint<D, Real> support(const glm::vec<D, Real>& direction) const {
    SupportPoint<D, Real> farthest{centre, 0};
    for (int axis = 0; axis < D; ++axis) {
      const Real along = glm::dot(direction, half_axes[axis]);
      farthest.point += std::copysign(Real(1), along) * half_axes[axis];
      farthest.index |= static_cast<std::uint32_t>(std::signbit(along)) << axis;
    }
    return farthest;
  }
  glm::vec<D, Real> point(std::uint32_t index) const {
    glm::vec<D, Real> point = centre;
    for (int axis = 0; axis < D; ++axis) point += kSigns[index & 7][axis] * half_axes[axis];
    return point;
  }
  Real extent() const { return largest_of(size_of(centre)) + half_diagonal; }

 private:
  static constexpr Real kSigns[8][3] = {{1, 1, 1},  {-1, 1, 1},  {1, -1, 1},  {-1, -1, 1},
                                        {1, 1, -1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, -1}};
};

template <int D, typename Stored, typename Real>
struct VerticesCore {
  std::span<const glm::vec<D, Stored>> vertices;
  glm::vec<D, Real> origin;
  glm::vec<D, Real> centre;  // of the query's frame: the first vertex

  SupportPoint<D, Real> support(const glm::vec<D, Real>& direction) const {
    std::uint32_t best = 0;
    Real farthest = glm::dot(direction, point(0));
    for (std::uint32_t index = 1; index < vertices.size(); ++index) {
      const Real along = glm::dot(direction, point(index));
      best = along > farthest ? index : best;
      farthest = along > farthest ? along : farthest;
    }
    return {point(best), best};
  }
  glm::vec<D, Real> point(std::uint32_t index) const {
    return glm::vec<D, Real>(vertices[index < vertices.size() ? index : 0]) - origin;
  }
  Real extent() const {
    glm::vec<D, Real> farthest(Real(0));
    for (std::uint32_t index = 0; index < vertices.size(); ++index)
      farthest = glm::max(farthest, size_of(point(index)));
    return largest_of(farthest);
  }
};

template <typename Stored, typename Real>
struct HullCore {
  const PlacedHull<Stored>* hull;
  glm::vec<3, Real> centre;
  glm::mat<3, 3, Real> axes;
  mutable std::uint32_t last = 0;  // where the next climb begins

  SupportPoint<3, Real> support(const glm::vec<3, Real>& direction) const {
    const glm::vec<3, Real> own = direction * axes;
    const auto along = [&](std::uint32_t index) {
      return glm::dot(own, glm::vec<3, Real>(hull->vertices_m[index]));
    };
    std::uint32_t best = 0;
    if (hull->neighbours.empty() || hull->vertices_m.size() < kLeastClimbedVertices) {
      Real farthest = along(0);
      for (std::uint32_t index = 1; index < hull->vertices_m.size(); ++index) {
        const Real here = along(index);
        best = here > farthest ? index : best;
        farthest = here > farthest ? here : farthest;
      }
    } else {
      best = last;
      Real farthest = along(best);
      for (bool climbs = true; climbs;) {
        climbs = false;
        const std::uint32_t end = hull->first_neighbour[best + 1];
        for (std::uint32_t n = hull->first_neighbour[best]; n < end; ++n) {
          const Real here = along(hull->neighbours[n]);
          if (!(here > farthest)) continue;
          farthest = here;
          best = hull->neighbours[n];
          climbs = true;
        }
      }
      last = best;
    }
    return {point(best), best};
  }
  glm::vec<3, Real> point(std::uint32_t index) const {
    return centre + axes * glm::vec<3, Real>(hull->vertices_m[index < hull->vertices_m.size() ? index : 0]);
  }
  Real extent() const { return largest_of(size_of(centre)) + static_cast<Real>(hull->extent_m); }
};

// What a query is centred on.
template <int D, typename Real>
glm::vec<D, Real> centre_of(const SphereShape<D, Real>& shape) {
  return shape.centre_m;
}
template <int D, typename Real>
glm::vec<D, Real> centre_of(const CapsuleShape<D, Real>& shape) {
  return shape.from_m + Real(0.5) * (shape.to_m - shape.from_m);
}
template <int D, typename Real>
glm::vec<D, Real> centre_of(const BoxShape<D, Real>& shape) {
  return shape.centre_m;
}
template <int D, typename Real>
glm::vec<D, Real> centre_of(const ConvexVertices<D, Real>& shape) {
  assert(!shape.vertices_m.empty());
  return shape.vertices_m[0];
}
template <typename Real>
glm::vec<3, Real> centre_of(const PlacedHull<Real>& shape) {
  return shape.origin_m;
}

// How far the shape reaches beyond its core.
template <typename Shape>
auto radius_of(const Shape& shape) {
  using Real = typename decltype(centre_of(shape))::value_type;
  if constexpr (requires { shape.radius_m; }) {
    return shape.radius_m;
  } else {
    return Real(0);
  }
}

// Cores relative to `origin`, computed in Real.
template <typename Real, int D, typename Stored>
PointCore<D, Real> core_of(const SphereShape<D, Stored>& shape, const glm::vec<D, Real>& origin) {
  return {glm::vec<D, Real>(shape.centre_m) - origin};
}
template <typename Real, int D, typename Stored>
SegmentCore<D, Real> core_of(const CapsuleShape<D, Stored>& shape, const glm::vec<D, Real>& origin) {
  const glm::vec<D, Real> from = glm::vec<D, Real>(shape.from_m) - origin;
  const glm::vec<D, Real> to = glm::vec<D, Real>(shape.to_m) - origin;
  return {Real(0.5) * (from + to), from, to};
}
template <typename Real, int D, typename Stored>
BoxCore<D, Real> core_of(const BoxShape<D, Stored>& shape, const glm::vec<D, Real>& origin) {
  BoxCore<D, Real> core;
  core.centre = glm::vec<D, Real>(shape.centre_m) - origin;
  const glm::vec<D, Real> half_extents(shape.half_extents_m);
  core.half_diagonal = std::sqrt(glm::dot(half_extents, half_extents));
  for (int axis = 0; axis < D; ++axis)
    core.half_axes[axis] = half_extents[axis] * glm::vec<D, Real>(shape.axes[axis]);
  return core;
}
template <typename Real, int D, typename Stored>
VerticesCore<D, Stored, Real> core_of(const ConvexVertices<D, Stored>& shape,
                                      const glm::vec<D, Real>& origin) {
  return {shape.vertices_m, origin, glm::vec<D, Real>(shape.vertices_m[0]) - origin};
}
template <typename Real, typename Stored>
HullCore<Stored, Real> core_of(const PlacedHull<Stored>& shape, const glm::vec<3, Real>& origin) {
  assert(!shape.vertices_m.empty());
  return {&shape, glm::vec<3, Real>(shape.origin_m) - origin, glm::mat<3, 3, Real>(shape.axes)};
}

}  // namespace prairie
