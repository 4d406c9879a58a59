// A window that moves over an endless lattice of texels, kept as a torus: texel (i, j) lies at (i mod side, j
// mod side), row by row from the south, so that what stays in the window stays where it is.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>

namespace prairie {

/// i mod side, 0 … side − 1.
inline int wrapped(int i, int side) {
  return ((i % side) + side) % side;
}

inline std::size_t torus_index(int i, int j, int side) {
  return static_cast<std::size_t>(wrapped(j, side)) * static_cast<std::size_t>(side) +
         static_cast<std::size_t>(wrapped(i, side));
}

/// The south-western texel of the window around an eye. An even side has a corner in its middle.
inline glm::ivec2 corner_around(glm::dvec2 eye_m, double texel_m, int side) {
  return {static_cast<int>(std::floor(eye_m.x / texel_m + 0.5)) - side / 2,
          static_cast<int>(std::floor(eye_m.y / texel_m + 0.5)) - side / 2};
}

}  // namespace prairie
