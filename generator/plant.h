// Planting on the CPU: from maps and seed to blades (G03 §3.2; docs/design.md, D2). The blades are those that
// the compute shader plants: both run shaders/kernels/plant.glsl.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/meadow.h"
#include "generator/tiles.h"
#include "shaders/shared/layouts.h"

namespace prairie {

/// All blades of a tile, ordered by species, cell, index in the cell. Positions are relative to the tile's
/// south-west corner (x, y) and to `tile_base_m` (z, generator/cell_table.h), in metres.
std::vector<Blade> plant_tile(const Meadow& meadow, TileId tile);

/// A hash of everything that `plant_tile` returns; equal on every compiler, optimisation level and thread
/// count.
std::uint64_t tile_hash(const Meadow& meadow, TileId tile);

/// Hashes of all tiles of a range, ordered by j then i, planted in parallel.
std::vector<std::uint64_t> tile_hashes(const Meadow& meadow, const TileRange& tiles);

/// How many blades `plant_tile` returns, without planting them.
std::uint64_t planted_count(const Meadow& meadow, TileId tile);

/// The integral of the density over the tile, per species (what `planted_count` has as its expectation).
std::vector<double> expected_counts(const Meadow& meadow, TileId tile);

}  // namespace prairie
