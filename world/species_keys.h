// A species' parameters as the scene file names them: keys with units people think in (mm, degrees), their
// ranges, and the values of a plain meadow fescue where a key is absent.
#pragma once

#include "shaders/shared/layouts.h"
#include "world/toml_reader.h"

namespace prairie {

SpeciesParams default_species_params();

/// Overwrites the parameters that the table sets. Throws BadInput.
void read_species_params(TableReader& table, SpeciesParams& params);

}  // namespace prairie
