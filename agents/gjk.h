// The distance of two convex shapes and where they are nearest, by GJK (Gilbert, Johnson & Keerthi 1988) with
// the signed volumes of Montanari, Petrinic & Barbieri 2017 (agents/simplex.h), and how deep they are in one
// another where they overlap (agents/expanding_polytope.h).
//
// Deviation: an answer is accepted by its certificate alone. The simplex's nearest point v bounds the
// distance from above; the plane through the farthest point against v, at right angles to v, bounds it from
// below (van den Bergen 2003, ch. 4). Where rounding keeps the two apart, the query is made again in the
// next wider type, whose answer is given in any case. All is computed relative to A's centre, so that far
// from the origin nothing is lost but what the coordinates themselves have lost. Nearest points follow less
// sharply than the distance: aside of one another they may be off by the root of what the distance is off,
// about 1e-4 of the shapes' size in float.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <type_traits>

#include "agents/convex_shapes.h"
#include "agents/gjk_descent.h"
#include "agents/shape_distance.h"
#include "agents/support_cores.h"

namespace prairie {

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

template <typename Real, bool kIsLast, typename A, typename B, int D, typename Stored>
[[gnu::always_inline]] inline CoreDistance<D, Real> distance_about(const A& a, const B& b,
                                                                   const glm::vec<D, Stored>& origin_m,
                                                                   GjkCache& cache) {
  const glm::vec<D, Real> origin(origin_m);
  CoreDistance<D, Real> found =
      core_distance<D, Real, kIsLast>(core_of<Real>(a, origin), core_of<Real>(b, origin), cache);
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
  const ShapeDistance<D, Wider> wide = distance_about<Wider, true>(a, b, origin_m, cache).answer;
  return {.distance_m = static_cast<Real>(wide.distance_m),
          .point_on_a_m = glm::vec<D, Real>(wide.point_on_a_m),
          .point_on_b_m = glm::vec<D, Real>(wide.point_on_b_m),
          .normal = glm::vec<D, Real>(wide.normal),
          .iterations = wide.iterations};
}

/// Of any two shapes of the same dimension and type. Their numbers are finite; sizes and distances other than
/// 0 are between 1e-6 and 1e6 m, wherever the scene is. Always ends with a finite answer. Starts from the
/// cache and leaves its own simplex there; allocates nothing.
template <typename A, typename B>
auto shape_distance(const A& a, const B& b, GjkCache& cache) {
  const auto origin_m = centre_of(a);
  using Real = typename decltype(origin_m)::value_type;
  static_assert(std::is_same_v<decltype(centre_of(a)), decltype(centre_of(b))>);
  auto found = distance_about<Real, false>(a, b, origin_m, cache);
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
