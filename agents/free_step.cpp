#include "agents/free_step.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace prairie {
namespace {

constexpr double kRounding = 1e-12;  // metres

/// By how much the worst of the limits is broken.
double excess_m(glm::dvec2 step_m, std::span<const StepLimit> limits) {
  double worst_m = 0.0;
  for (const StepLimit& limit : limits)
    worst_m = std::max(worst_m, glm::dot(limit.toward, step_m) - limit.room_m);
  return worst_m;
}

}  // namespace

// The optimum is the wish itself, its foot on one limit's line, or a corner of two.
glm::dvec2 free_step(glm::dvec2 wanted_m, std::span<const StepLimit> limits) {
  if (excess_m(wanted_m, limits) <= kRounding) return wanted_m;
  glm::dvec2 best_m(0.0);
  double least_excess_m = excess_m(best_m, limits);
  double least_way =
      least_excess_m <= kRounding ? glm::length(wanted_m) : std::numeric_limits<double>::infinity();
  const auto consider = [&](glm::dvec2 step_m) {
    const double over_m = excess_m(step_m, limits), way = glm::length(step_m - wanted_m);
    const bool is_allowed = over_m <= kRounding, was_allowed = least_excess_m <= kRounding;
    if (is_allowed ? (was_allowed && way >= least_way) : (was_allowed || over_m >= least_excess_m)) return;
    best_m = step_m;
    least_excess_m = over_m;
    least_way = way;
  };
  for (std::size_t a = 0; a < limits.size(); ++a) {
    const StepLimit& first = limits[a];
    consider(wanted_m - std::max(glm::dot(first.toward, wanted_m) - first.room_m, 0.0) * first.toward);
    for (std::size_t b = a + 1; b < limits.size(); ++b) {
      const StepLimit& second = limits[b];
      const double across = first.toward.x * second.toward.y - first.toward.y * second.toward.x;
      if (std::abs(across) < 1e-6) continue;
      const glm::dvec2 corner_m(first.room_m * second.toward.y - second.room_m * first.toward.y,
                                second.room_m * first.toward.x - first.room_m * second.toward.x);
      // A corner of nearly parallel lines lies far away.
      const glm::dvec2 at_m = corner_m / across;
      if (glm::length(at_m) <= 2.0 * glm::length(wanted_m) + std::abs(first.room_m) + std::abs(second.room_m))
        consider(at_m);
    }
  }
  return best_m;
}

}  // namespace prairie
