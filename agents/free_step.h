// The step nearest to a wanted one that stays in front of lines: an exact quadratic programme in the plane
// with few constraints.
#pragma once

#include <glm/vec2.hpp>
#include <span>

namespace prairie {

/// Steps x with dot(toward, x) ≤ room_m are allowed.
struct StepLimit {
  glm::dvec2 toward{1.0, 0.0};  // unit
  double room_m = 0.0;          // negative: it has to move back by so much
};

/// Where nothing satisfies all limits, what breaks them least among the ends of two of them and standing
/// still.
glm::dvec2 free_step(glm::dvec2 wanted_m, std::span<const StepLimit> limits);

}  // namespace prairie
