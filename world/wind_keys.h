// The section [wind] of a scene: a steady or a measured wind, its turbulence, and gusts, tornadoes and
// breezes.
#pragma once

#include <filesystem>

#include "world/scene.h"
#include "world/toml_reader.h"

namespace prairie {

/// Throws BadInput. `folder` is where a relative path of a measured series starts.
WindSpec read_wind(TableReader& table, const std::filesystem::path& folder);

}  // namespace prairie
