// Windows around the eye that hold a field as textures: layouts::kSwayLevels of them, of side × side texels
// that are kSwayCoarsening times as large from one to the next, finest first. Texels lie on a fixed lattice
// of the ground, texel (i, j) covering [i, i + 1) × [j, j + 1) · window_texel_m; a window is kept as a torus,
// (i mod side, j mod side), row by row from the south, so that a texture of it that repeats is sampled at
// position / (side · texel). Near its border each window fades into the next coarser one and the last into
// its mean, so that neither grass nor the eye's steps show where one ends, and a shader picks one window and
// needs no blend.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "shaders/shared/layouts.h"

namespace prairie {

inline constexpr std::size_t kWindowLevels = layouts::kSwayLevels;
inline constexpr std::size_t kWindowTexels = std::size_t{layouts::kSwaySide} * layouts::kSwaySide;

double window_texel_m(std::size_t level);
/// Half the width.
double window_half_m(std::size_t level);

/// Where texel (i, j) of the lattice lies in the torus.
std::size_t window_index(int i, int j);
/// The south-western texel of the window around an eye.
glm::ivec2 window_corner(std::size_t level, glm::dvec2 eye_m);

/// Where a window of half width `half_m` begins to fade into what lies around it, and where it has; by the
/// distance from the centre along the farther axis.
double fade_start_m(double half_m);
double fade_end_m(double half_m);

/// Fades tori of a window into those of the next coarser one, each into that of the same place in the list,
/// once these have been faded themselves; those of the last window, which have no coarser ones, into their
/// means.
void fade_window(std::size_t level, glm::dvec2 centre_m, std::span<glm::vec4* const> tori,
                 std::span<const glm::vec4* const> coarser);

/// Where the windows hold a place: the finest one that it lies in, as field_place in
/// shaders/lib/moving_fields.glsl.
struct WindowPlace {
  std::size_t level;
  glm::dvec2 position_m;
};
WindowPlace window_place(glm::dvec2 centre_m, glm::dvec2 position_m);

/// What lies between four texels of a torus, bilinear.
struct WindowBlend {
  std::array<std::size_t, 4> from;  // south-west, south-east, north-west, north-east
  float east, north;                // 0…1

  glm::vec4 of(const glm::vec4* torus) const {
    const glm::vec4 south = torus[from[0]] + (torus[from[1]] - torus[from[0]]) * east;
    const glm::vec4 norths = torus[from[2]] + (torus[from[3]] - torus[from[2]]) * east;
    return south + (norths - south) * north;
  }
};
WindowBlend window_blend(std::size_t level, glm::dvec2 position_m);

}  // namespace prairie
