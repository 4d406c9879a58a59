// The sections [[condition]] of a scene: what has come over the grass of a place.
#pragma once

#include <vector>

#include "animation/condition.h"
#include "world/toml_reader.h"

namespace prairie {

/// In the file's order. Throws BadInput.
std::vector<Condition> read_conditions(TableReader& root);

}  // namespace prairie
