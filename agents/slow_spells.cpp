#include "agents/slow_spells.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <span>

namespace prairie {
namespace {

/// A polynomial by its coefficients, of rising power.
double value(std::span<const double> coefficients, double u) {
  double sum = 0.0;
  for (std::size_t n = coefficients.size(); n-- > 0;) sum = sum * u + coefficients[n];
  return sum;
}

/// Between `low` and `high`, where the polynomial has different signs and one zero.
double zero_between(std::span<const double> coefficients, double low, double high) {
  const bool starts_below = value(coefficients, low) < 0.0;
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (value(coefficients, middle) < 0.0 ? starts_below : !starts_below) ? low = middle : high = middle;
  }
}

/// 0, where the polynomial changes its sign in between, and 1: it does so at most once from one change of its
/// slope's sign to the next.
std::vector<double> pieces_of_one_sign(std::span<const double> coefficients) {
  if (coefficients.size() < 2) return {0.0, 1.0};
  std::vector<double> slope;
  for (std::size_t n = 1; n < coefficients.size(); ++n)
    slope.push_back(static_cast<double>(n) * coefficients[n]);
  const std::vector<double> turns = pieces_of_one_sign(slope);
  std::vector<double> cuts{0.0};
  for (std::size_t n = 1; n < turns.size(); ++n) {
    if ((value(coefficients, turns[n - 1]) < 0.0) == (value(coefficients, turns[n]) < 0.0)) continue;
    const double zero = zero_between(coefficients, turns[n - 1], turns[n]);
    if (zero > cuts.back() && zero < 1.0) cuts.push_back(zero);
  }
  cuts.push_back(1.0);
  return cuts;
}

/// The velocity lies in the triangle of its Bézier points; where that is beyond the limit in one direction,
/// so is all of it.
bool surely_fast(const PieceVelocity& v, double limit_m_per_s) {
  const glm::dvec2 middle = v.constant + 0.5 * v.linear, end = v.constant + v.linear + v.square;
  const glm::dvec2 along = v.constant + middle + end;
  const double bound = limit_m_per_s * glm::length(along);
  return glm::dot(v.constant, along) > bound && glm::dot(middle, along) > bound &&
         glm::dot(end, along) > bound;
}

}  // namespace

std::vector<SlowSpell> slow_spells(const PieceVelocity& v, double limit_m_per_s) {
  if (surely_fast(v, limit_m_per_s)) return {};
  // |v|² − limit²
  const double excess[] = {glm::dot(v.constant, v.constant) - limit_m_per_s * limit_m_per_s,
                           2.0 * glm::dot(v.constant, v.linear),
                           glm::dot(v.linear, v.linear) + 2.0 * glm::dot(v.constant, v.square),
                           2.0 * glm::dot(v.linear, v.square), glm::dot(v.square, v.square)};
  const std::vector<double> cuts = pieces_of_one_sign(excess);
  std::vector<SlowSpell> spells;
  for (std::size_t n = 1; n < cuts.size(); ++n) {
    if (value(excess, 0.5 * (cuts[n - 1] + cuts[n])) >= 0.0) continue;
    if (!spells.empty() && spells.back().to == cuts[n - 1]) {
      spells.back().to = cuts[n];
    } else {
      spells.push_back({cuts[n - 1], cuts[n]});
    }
  }
  return spells;
}

}  // namespace prairie
