// `--tiles`: which of a meadow's tiles a command works on.
#pragma once

#include <optional>

#include "generator/tiles.h"

namespace prairie {

/// The tiles asked for, or all. Throws UsageError where one lies outside the field (a repeating field has no
/// outside).
TileRange chosen_tiles(const std::optional<TileRange>& asked, const Meadow& meadow);

}  // namespace prairie
