// The flat tier's texture (G03 §3.5): the mean colour of the blades that the maps plant, and how much of the
// ground they cover, at the density maps' resolution.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "generator/meadow.h"

namespace prairie {

struct FlatMap {
  int columns = 0;
  int rows = 0;              // rows from south
  glm::dvec2 period_m{1.0};  // size of the texture in the scene: texel (0, 0) has its centre on the origin
  std::vector<std::uint8_t>
      srgb_and_cover;  // 4 bytes a texel: mean albedo of the blades (sRGB-encoded), cover
};

/// Mean albedo of a species' visible leaves.
glm::vec3 mean_albedo(const SpeciesParams& species);

/// `blade_area_from_above_m2`: what one blade of each species shows from above. Texel centres lie on the
/// field's borders (where it repeats, on its western and southern one). Maps finer than the texels are
/// averaged over them.
FlatMap make_flat_map(const Meadow& meadow, std::span<const double> blade_area_from_above_m2);

}  // namespace prairie
