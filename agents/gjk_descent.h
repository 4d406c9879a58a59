// GJK between two cores (agents/support_cores.h), from cold or from a cached simplex, and the way out where
// they overlap; agents/gjk.h says after whom, and is what to call.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <type_traits>

#include "agents/expanding_polytope.h"
#include "agents/shape_distance.h"
#include "agents/simplex.h"
#include "agents/support_cores.h"

namespace prairie {

/// Steps of GJK after which it stops; those of the expanding polytope are bounded by its vertices.
inline constexpr int kMostGjkIterations = 64;

/// What bounds an error of the kind that rounding makes in A - B, by its points' size.
template <typename Real>
inline constexpr Real kGjkRounding = Real(2) * std::numeric_limits<Real>::epsilon();
/// A gap between the bounds, relative to the distance, at which it is known well enough.
template <typename Real>
inline constexpr Real kGjkGap = std::is_same_v<Real, float> ? Real(1e-7) : Real(1e-12);

/// Of two cores, both relative to the same origin.
template <int D, typename Real>
struct CoreDistance {
  ShapeDistance<D, Real> answer;
  bool is_certain = false;
};

/// How far the descent to the origin has come.
template <int D, typename Real>
struct GjkDescent {
  Simplex<D, Real> simplex;
  glm::vec<D, Real> nearest;                        // of the simplex to the origin
  Real squared = std::numeric_limits<Real>::max();  // its distance's square, once it is a point of A - B
  Real below = 0;                                   // the lower bound times that distance
  int iterations = 0;
  bool overlaps = false;
};

/// Closes in on the origin until the bounds are `tolerance` apart or rounding stops it.
template <int D, typename Real, typename CoreA, typename CoreB>
[[gnu::always_inline]] inline GjkDescent<D, Real> descend(const CoreA& a, const CoreB& b,
                                                          const GjkCache& cache, Real tolerance) {
  const Real tolerance2 = tolerance * tolerance;
  GjkDescent<D, Real> descent;
  Simplex<D, Real>& simplex = descent.simplex;
  glm::vec<D, Real>& nearest = descent.nearest;
  Real& squared = descent.squared;

  nearest = a.centre - b.centre;
  if (cache.count > 0) {
    simplex.count = std::min(static_cast<int>(cache.count), D + 1);
    for (int i = 0; i < simplex.count; ++i) {
      simplex.keys[i] = cache.keys[i];
      simplex.on_a[i] = a.point(static_cast<std::uint32_t>(cache.keys[i] >> 32));
      simplex.points[i] = simplex.on_a[i] - b.point(static_cast<std::uint32_t>(cache.keys[i]));
    }
    const SimplexFace<D, Real> face = nearest_to_origin(simplex);
    reduce(simplex, face);
    if (face.count > 0) {
      nearest = face.nearest;
      squared = face.squared;
    }
  }

  descent.overlaps = squared <= tolerance2;
  while (!descent.overlaps && descent.iterations < kMostGjkIterations) {
    ++descent.iterations;
    const auto on_a = a.support(-nearest);
    const auto on_b = b.support(nearest);
    const glm::vec<D, Real> point = on_a.point - on_b.point;
    const std::uint64_t key = (static_cast<std::uint64_t>(on_a.index) << 32) | on_b.index;
    descent.below = glm::dot(nearest, point);
    const Real gap = squared - descent.below;
    if (gap <= kGjkGap<Real> * squared || gap * gap <= tolerance2 * squared) break;
    bool is_known = false;
    for (int i = 0; i < simplex.count; ++i) is_known = is_known || simplex.keys[i] == key;
    if (is_known) break;

    simplex.points[simplex.count] = point;
    simplex.on_a[simplex.count] = on_a.point;
    simplex.keys[simplex.count] = key;
    ++simplex.count;
    const SimplexFace<D, Real> face = nearest_to_origin(simplex);
    if (!(face.squared < squared)) {
      --simplex.count;
      break;
    }
    reduce(simplex, face);
    nearest = face.nearest;
    squared = face.squared;
    descent.overlaps = squared <= tolerance2;
  }
  return descent;
}

/// The distance at which a descent has ended, and where.
template <int D, typename Real>
[[gnu::always_inline]] inline ShapeDistance<D, Real> answer_of(const GjkDescent<D, Real>& descent) {
  ShapeDistance<D, Real> answer;
  glm::vec<D, Real> apart(Real(0));  // from B's point to A's
  for (int i = 0; i < descent.simplex.count; ++i) {
    apart += descent.simplex.weights[i] * descent.simplex.points[i];
    answer.point_on_a_m += descent.simplex.weights[i] * descent.simplex.on_a[i];
  }
  answer.point_on_b_m = answer.point_on_a_m - apart;
  answer.distance_m = std::sqrt(glm::dot(apart, apart));
  answer.normal = (Real(-1) / std::sqrt(descent.squared)) * descent.nearest;
  answer.iterations = descent.iterations;
  return answer;
}

template <typename Core, int D, typename Real>
struct MovedCore {
  const Core& core;
  glm::vec<D, Real> way;
  glm::vec<D, Real> centre = core.centre + way;

  SupportPoint<D, Real> support(const glm::vec<D, Real>& direction) const {
    SupportPoint<D, Real> farthest = core.support(direction);
    farthest.point += way;
    return farthest;
  }
  glm::vec<D, Real> point(std::uint32_t index) const { return core.point(index) + way; }
};

/// How the way out of shapes of that size is sought. A query that is not made again (`kIsLast`) looks for
/// corners alone, and knows depths as well as the narrower type that asked: what is thinner than that is
/// flat. In the plane rounding makes no slivers.
template <int D, typename Real, bool kIsLast>
PolytopeRules<Real> polytope_rules(Real tolerance, Real scale) {
  if constexpr (D == 2) return {.tolerance = tolerance};
  constexpr bool kForFloat = std::is_same_v<Real, double> && kIsLast;
  if (kIsLast) {
    return {.tolerance = (kForFloat ? Real(1e-9) : Real(1e-13)) * scale,
            .tie_break = kForFloat ? Real(1e-7) : Real(1e-9)};
  }
  // A plane that is tilted by rounding is off by no more than this share of the size.
  constexpr Real kMostTilt = std::is_same_v<Real, float> ? Real(4e-6) : Real(1e-11);
  return {.tolerance = tolerance, .least_height = tolerance / kMostTilt};
}

/// The points are those that are nearest once B has been moved out of A and as far again as the shapes are
/// large.
template <int D, typename Real, bool kIsLast, typename CoreA, typename CoreB>
[[gnu::noinline]] CoreDistance<D, Real> core_depth(const CoreA& a, const CoreB& b, Real tolerance,
                                                   Real scale) {
  const Penetration<D, Real> out = penetration<D, Real>(
      [&](const glm::vec<D, Real>& direction) {
        const auto on_a = a.support(direction), on_b = b.support(-direction);
        return PolytopeVertex<D, Real>{on_a.point - on_b.point,
                                       (static_cast<std::uint64_t>(on_a.index) << 32) | on_b.index};
      },
      polytope_rules<D, Real, kIsLast>(tolerance, scale));
  const glm::vec<D, Real> way = (out.depth + (scale > Real(0) ? scale : Real(1))) * out.normal;
  const MovedCore<CoreB, D, Real> moved{b, way};
  CoreDistance<D, Real> found;
  found.answer = answer_of(descend<D, Real>(a, moved, GjkCache{}, tolerance));
  found.answer.point_on_b_m -= way;
  found.answer.distance_m = -out.depth;
  found.answer.normal = out.normal;
  found.answer.iterations += out.iterations;
  found.is_certain = out.is_certain && out.depth >= -tolerance;
  return found;
}

template <int D, typename Real, bool kIsLast, typename CoreA, typename CoreB>
[[gnu::always_inline]] inline CoreDistance<D, Real> core_distance(const CoreA& a, const CoreB& b,
                                                                  GjkCache& cache) {
  const Real scale = std::max(a.extent(), b.extent());
  const Real tolerance = kGjkRounding<Real> * scale;
  const GjkDescent<D, Real> descent = descend<D, Real>(a, b, cache, tolerance);
  cache.count = static_cast<std::uint32_t>(descent.simplex.count);
  for (int i = 0; i < descent.simplex.count; ++i) cache.keys[i] = descent.simplex.keys[i];
  bool may_overlap = descent.overlaps;
  if constexpr (D == 3 && kIsLast) {
    // Where thin shapes overlap the descent may stop short of the origin, at a flat simplex beside it.
    const Real flat = polytope_rules<D, Real, kIsLast>(tolerance, scale).tolerance;
    may_overlap = may_overlap || descent.squared <= flat * flat;
  }
  if (may_overlap) {
    CoreDistance<D, Real> found = core_depth<D, Real, kIsLast>(a, b, Real(2) * tolerance, scale);
    found.answer.iterations += descent.iterations;
    return found;
  }
  CoreDistance<D, Real> found;
  found.answer = answer_of(descent);
  found.is_certain = found.answer.distance_m - descent.below / std::sqrt(descent.squared) <=
                     Real(10) * kGjkGap<Real> * found.answer.distance_m + Real(2) * tolerance;
  return found;
}

}  // namespace prairie
