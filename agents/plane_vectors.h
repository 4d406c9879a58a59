// Vectors of the plane, by +, −, ×, ÷ and √ alone.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace prairie {

inline glm::dvec2 left_of(glm::dvec2 forward) {
  return {-forward.y, forward.x};
}

/// Of its length; `otherwise` where it has hardly any.
inline glm::dvec2 unit(glm::dvec2 v, glm::dvec2 otherwise) {
  const double length = glm::length(v);
  return length > 1e-9 ? v / length : otherwise;
}

/// Turned to the left by the angle whose half has this tangent.
inline glm::dvec2 turned_by_half_tangent(glm::dvec2 forward, double t) {
  const double cosine = (1.0 - t * t) / (1.0 + t * t), sine = 2.0 * t / (1.0 + t * t);
  return cosine * forward + sine * left_of(forward);
}

}  // namespace prairie
