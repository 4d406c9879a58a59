// Directions in the plane by the kernels' sine and cosine, so that they are the same everywhere.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "shaders/kernels/kernels.h"

namespace prairie {

/// Sine of a number of turns, −1…1 to 4e-7, for any number of them.
inline double sine_of_turns(double turns) {
  const double turn = turns - std::floor(turns);
  return static_cast<double>(Kernels{}.sine(static_cast<float>(turn * 6.283185307179586)));
}

/// Unit vector to 4e-7; `heading_rad` from east, counter-clockwise.
inline glm::dvec2 direction_of(double heading_rad) {
  const double turns = heading_rad * 0.15915494309189535;
  return {sine_of_turns(turns + 0.25), sine_of_turns(turns)};
}

}  // namespace prairie
