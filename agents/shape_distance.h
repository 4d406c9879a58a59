// What a query for the distance of two shapes returns and what it keeps for the next one (agents/gjk.h).
// Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace prairie {

/// The simplex that a query ended with, from which the next one of the same two shapes starts, moved or not.
/// With a cache of other shapes the answer is right as well, but later. Plain data, all zero at first.
/// Answers from the cache differ from others by rounding: state that depends on them holds the cache, too.
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

}  // namespace prairie
