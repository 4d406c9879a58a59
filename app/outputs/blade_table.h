// Planted blades as a table for other programs: CSV text or binary PLY, one row or vertex per blade, in the
// scene's coordinates (metres; x east, y north, z up).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "generator/meadow.h"
#include "generator/tiles.h"

namespace prairie {

enum class BladeTableFormat { kCsv, kPly };

/// What comes before the blades; PLY states their number, and lists the species in comments.
std::string blade_table_header(BladeTableFormat format, const Meadow& meadow, std::uint64_t blade_count);

/// The blades of one tile.
std::string blade_rows(BladeTableFormat format, const Meadow& meadow, TileId tile,
                       std::span<const Blade> blades);

}  // namespace prairie
