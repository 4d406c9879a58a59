// Names that a scene gives to its species, cameras and movers.
#pragma once

#include <string>
#include <vector>

#include "world/toml_reader.h"

namespace prairie {

/// The table's key `name`: letters, digits, '_', '-' and spaces, a letter first, and not one of those
/// `taken`. Throws BadInput.
std::string read_name(TableReader& table, const std::vector<std::string>& taken);

}  // namespace prairie
