// A meadow of one or two species on level or sloping ground, and what moves it, for tests of fields and
// blades.
#pragma once

#include "animation/standing_blade.h"
#include "generator/meadow.h"

namespace prairie::testing {

inline SpeciesParams moving_species(float height_m, float stiffness) {
  SpeciesParams params{};
  params.height_m = height_m;
  params.height_spread = 0.3f;
  params.width_m = 0.004f;
  params.tilt_rad = 0.2f;
  params.lean_rad = 0.15f;
  params.curvature_rad = 0.7f;
  params.curvature_spread = 0.4f;
  params.mass_g = 0.06f;
  params.stiffness = stiffness;
  params.stiffness_spread = 0.3f;
  params.clump_m = 0.3f;
  params.clump_strength = 0.5f;
  params.clump_spray_rad = 0.2f;
  return params;
}

/// 24 m × 24 m.
inline Meadow moving_meadow(float density_per_m2) {
  Meadow meadow;
  meadow.extent_m = {24.0, 24.0};
  meadow.species.push_back({{"short", moving_species(0.32f, 70.0f)}, NodeGrid::uniform(density_per_m2)});
  meadow.species.push_back({{"tall", moving_species(0.6f, 45.0f)}, NodeGrid::uniform(0.2f * density_per_m2)});
  return meadow;
}

inline std::vector<ChainTraits> moving_traits() {
  return {{0.04f, 70.0f, 0.2f, 0.25f}, {0.075f, 45.0f, 0.25f, 0.35f}};
}

inline std::vector<SwaySpecies> moving_sway() {
  return {{moving_traits()[0], 0.7f}, {moving_traits()[1], 0.3f}};
}

}  // namespace prairie::testing
