// Grasses to start from.
#pragma once

#include "shaders/shared/layouts.h"

namespace prairie {

/// A plain meadow fescue: what a species is where nothing else is said.
SpeciesParams fescue_params();

/// A taller, golden one that stands in drifts.
SpeciesParams oatgrass_params();

}  // namespace prairie
