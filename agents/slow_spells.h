// When somebody on a cubic way goes slower than a limit: exactly, so that no short halt between two sample
// times is missed.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace prairie {

/// The velocity on a piece of a cubic way: constant + linear · u + square · u², u from 0 to 1.
struct PieceVelocity {
  glm::dvec2 constant{0.0}, linear{0.0}, square{0.0};

  glm::dvec2 at(double u) const { return constant + u * (linear + u * square); }
};

struct SlowSpell {
  double from = 0.0, to = 0.0;  // of u, 0 ≤ from < to ≤ 1
};

/// Where |velocity| < limit_m_per_s (which is above 0); in order, none touching the next. The ends are found
/// by halving, to the last digits of double, with + − · alone.
std::vector<SlowSpell> slow_spells(const PieceVelocity& velocity, double limit_m_per_s);

}  // namespace prairie
