// The flat tier's texture (G03 §3.5): the mean colour of the blades that the maps plant, and how much of the
// ground they cover, at the density maps' resolution.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/meadow.h"

namespace prairie {

struct FlatMap {
  int columns = 0;
  int rows = 0;  // rows from south
  double texel_m = 1.0;
  std::vector<std::uint8_t>
      srgb_and_cover;  // 4 bytes a texel: mean albedo of the blades (sRGB-encoded), cover
};

/// Texel centres lie on the field's nodes: texel (0, 0) on the origin, the last ones on the far border.
FlatMap make_flat_map(const Meadow& meadow);

/// Share of the ground that blades of this density hide from above: leaf area that stands at random, 1 −
/// e^(−area).
double cover_from_above(const SpeciesParams& species, double density_per_m2);

}  // namespace prairie
