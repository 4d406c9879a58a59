#pragma once
#include "animation/inertial_chains.h"
#include "animation/wind.h"
#include "world/scene.h"
namespace prairie {
Wind wind_of(const Scene& scene);
ChainTraits chain_traits_of(const SpeciesSpec& spec);
}  // namespace prairie
