// The distance of two convex shapes and where they are nearest, by GJK (Gilbert, Johnson & Keerthi 1988) with the
// signed volumes of Montanari, Petrinic & Barbieri 2017 (agents/simplex.h), and how deep they are in one another where
// they overlap (agents/expanding_polytope.h).
//
// Deviation: an answer is accepted by its certificate alone. The simplex's nearest point v bounds the distance from
// above; the plane through the farthest point against v, at right angles to v, bounds it from below (van den Bergen 2003,
// §4.3.1). Where rounding keeps the two apart, the query is made again in the next wider type, whose answer is given in
// any case. All is computed relative to A's centre, so that far from the origin nothing is lost but what the
// coordinates themselves have lost. Nearest points follow less sharply than the distance: aside of one another they may be
// off by the root of what the distance is off, about 1e-4 of the shapes' size in float.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <type_traits>

#include "agents/convex_shapes.h"
#include "agents/expanding_polytope.h"
#include "agents/simplex.h"

namespace prairie {

/// The simplex that a query ended with, from which the next one of the same two shapes starts, moved or not. With a
/// cache of other shapes the answer is right as well, but later. Plain data, all zero at first. Answers from the cache
/// differ from others by rounding: state that depends on them holds the cache, too.
struct GjkCache {
  std::uint32_t count = 0;
  std::array<std::uint64_t, 4> keys{};  // index in A << 32 | index in B

  bool operator==(const GjkCache&) const = default;
};

template <int D, typename Real>
struct ShapeDistance {
  Real distance_m = 0;  // negative where they overlap: the shortest way along which B moves out of A
  glm::vec<D, Real> point_on_a_m{Real(0)};
  glm::vec<D, Real> point_on_b_m{Real(0)};  // point_on_a_m + distance_m * normal
  glm::vec<D, Real> normal{Real(0)};        // from A to B, a unit vector
  int iterations = 0;
};

/// Steps of GJK after which it stops; those of the expanding polytope are bounded by its vertices.
inline constexpr int kMostGjkIterations = 64;

/// What bounds an error of the kind that rounding makes in A - B, by its points' size.
template <typename Real>
inline constexpr Real kGjkRounding = Real(2) * std::numeric_limits<Real>::epsilon();
/// A gap between the bounds, relative to the distance, at which it is known well enough.
template <typename Real>
inline constexpr Real kGjkGap = std::is_same_v<Real, float> ? Real(1e-7) : Real(1e-12);

template <typename Real>
struct WiderReal;
template <>
struct WiderReal<float> {
  using Type = double;
};
template <>
struct WiderReal<double> {
  using Type = long double;
};

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
  glm::vec<D, Real> nearest;  // of the simplex to the origin
  Real squared = std::numeric_limits<Real>::max();  // its distance's square, once it is a point of A - B
  Real below = 0;  // the lower bound times that distance
  int iterations = 0;
  bool overlaps = false;
};

/// Closes in on the origin until the bounds are `tolerance` apart or rounding stops it.
template <int D, typename Real, typename CoreA, typename CoreB>
[[gnu::always_inline]] inline GjkDescent<D, Real> descend(const CoreA& a, const CoreB& b, const GjkCache& cache,
                                                          Real tolerance) {
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

/// The points are those that are nearest once B has been moved out of A and as far again as the shapes are large.
template <int D, typename Real, typename CoreA, typename CoreB>
[[gnu::noinline]] CoreDistance<D, Real> core_depth(const CoreA& a, const CoreB& b, Real tolerance, Real scale) {
  const Penetration<D, Real> out = penetration<D, Real>(
      [&](const glm::vec<D, Real>& direction) {
        const auto on_a = a.support(direction), on_b = b.support(-direction);
        return PolytopeVertex<D, Real>{on_a.point - on_b.point,
                                       (static_cast<std::uint64_t>(on_a.index) << 32) | on_b.index};
      },
      tolerance);
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

template <int D, typename Real, typename CoreA, typename CoreB>
[[gnu::always_inline]] inline CoreDistance<D, Real> core_distance(const CoreA& a, const CoreB& b, GjkCache& cache) {
  const Real scale = std::max(a.extent(), b.extent());
  const Real tolerance = kGjkRounding<Real> * scale;
  const GjkDescent<D, Real> descent = descend<D, Real>(a, b, cache, tolerance);
  cache.count = static_cast<std::uint32_t>(descent.simplex.count);
  for (int i = 0; i < descent.simplex.count; ++i) cache.keys[i] = descent.simplex.keys[i];
  if (descent.overlaps) {
    CoreDistance<D, Real> found = core_depth<D, Real>(a, b, Real(2) * tolerance, scale);
    found.answer.iterations += descent.iterations;
    return found;
  }
  CoreDistance<D, Real> found;
  found.answer = answer_of(descent);
  found.is_certain = found.answer.distance_m - descent.below / std::sqrt(descent.squared) <=
                     Real(10) * kGjkGap<Real> * found.answer.distance_m + Real(2) * tolerance;
  return found;
}

template <typename Real, typename A, typename B, int D, typename Stored>
[[gnu::always_inline]] inline CoreDistance<D, Real> distance_about(const A& a, const B& b,
                                                                   const glm::vec<D, Stored>& origin_m, GjkCache& cache) {
  const glm::vec<D, Real> origin(origin_m);
  CoreDistance<D, Real> found = core_distance<D, Real>(core_of<Real>(a, origin), core_of<Real>(b, origin), cache);
  const Real radius_a = static_cast<Real>(radius_of(a)), radius_b = static_cast<Real>(radius_of(b));
  found.answer.distance_m -= radius_a + radius_b;
  found.answer.point_on_a_m += radius_a * found.answer.normal;
  found.answer.point_on_b_m -= radius_b * found.answer.normal;
  return found;
}

template <typename A, typename B, int D, typename Real>
[[gnu::noinline, gnu::cold]] ShapeDistance<D, Real> wider_distance(const A& a, const B& b,
                                                                   const glm::vec<D, Real>& origin_m) {
  using Wider = typename WiderReal<Real>::Type;
  GjkCache cache;
  const ShapeDistance<D, Wider> wide = distance_about<Wider>(a, b, origin_m, cache).answer;
  return {.distance_m = static_cast<Real>(wide.distance_m),
          .point_on_a_m = glm::vec<D, Real>(wide.point_on_a_m),
          .point_on_b_m = glm::vec<D, Real>(wide.point_on_b_m),
          .normal = glm::vec<D, Real>(wide.normal),
          .iterations = wide.iterations};
}

/// Of any two shapes of agents/convex_shapes.h in the same dimension and type, whose numbers are finite and, those other
/// than 0, between 1e-6 and 1e6 m apart from the place of the scene. Always ends with a finite answer.
template <typename A, typename B>
auto shape_distance(const A& a, const B& b, GjkCache& cache) {
  const auto origin_m = centre_of(a);
  using Real = typename decltype(origin_m)::value_type;
  static_assert(std::is_same_v<decltype(centre_of(a)), decltype(centre_of(b))>);
  auto found = distance_about<Real>(a, b, origin_m, cache);
  if (!found.is_certain) [[unlikely]] {
    const int iterations = found.answer.iterations;
    found.answer = wider_distance(a, b, origin_m);
    found.answer.iterations += iterations;
  }
  found.answer.point_on_a_m += origin_m;
  found.answer.point_on_b_m += origin_m;
  return found.answer;
}

template <typename A, typename B>
auto shape_distance(const A& a, const B& b) {
  GjkCache cache;
  return shape_distance(a, b, cache);
}

}  // namespace prairie
