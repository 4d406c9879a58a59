// From what a scene says of its wind and its blades to what animation moves them by.
#pragma once

#include "animation/chain_block.h"
#include "animation/wind.h"
#include "world/scene/scene.h"

namespace prairie {

/// Mean wind, turbulence by the scene's seed, and primitives; calm air where the scene has no wind. Without a
/// camera's wake. Throws BadInput that names the file of a measured series, the line and what was expected.
/// `middle_m`: of the ground, where a measured series that tells no place holds.
Wind wind_of(const Scene& scene, glm::dvec2 middle_m = glm::dvec2(0.0));

/// Turbulence by the scene's seed, its strength times `factor` (0…10); none where the factor is 0.
std::optional<NoiseWind> turbulence_of(const Scene& scene, double factor);

/// Of a mean blade of the species.
ChainTraits chain_traits_of(const SpeciesSpec& spec);

}  // namespace prairie
