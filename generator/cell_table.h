// Cells made ready for the planting kernel: counts, seeds and the tables of floats that the kernel reads. The
// tables are made on the CPU alone, in double, so that both sides plant from the same bits.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/meadow.h"
#include "generator/tiles.h"
#include "shaders/shared/layouts.h"

namespace prairie {

/// What `PlantedCell::feature_table` holds where no feature map varies.
inline constexpr std::uint32_t kNoTable = 0xffffffffu;

/// Prepared cells; `PlantedCell`'s table texels are groups of four in `tables`.
struct CellTables {
  std::vector<PlantedCell> cells;
  std::vector<float> tables;
};

/// The patches that every cell of a species has, and every cell's features: found once per meadow.
struct PlantingLattice {
  explicit PlantingLattice(const Meadow& meadow);
  double cell_m;
  std::vector<int> density_patches;  // per species
  int feature_patches;               // 0: no feature map varies
};

/// Height that positions in a tile are relative to: the ground at its south-west corner, rounded to whole
/// metres so that every cell of the tile finds the same.
double tile_base_m(const Meadow& meadow, TileId tile);

/// Appends the cell of every species that has blades there (N ≥ 1).
void append_cell(const Meadow& meadow, const PlantingLattice& lattice, TileId tile, int cell,
                 CellTables& out);

/// A cell by itself: level ground from the origin on, one species of one density; empty where that comes to
/// no blade.
CellTables uniform_cell(const SpeciesParams& species, float density_per_m2, double side_m,
                        std::uint64_t seed);

/// The 3 × 3 heights of a cell's ground table, row by row from south, above the tile's base.
std::array<float, 9> ground_heights_m(const CellTables& tables, const PlantedCell& cell);

/// Integral of the density over the cell, per species: the expectation of N.
std::vector<double> expected_cell_counts(const Meadow& meadow, const PlantingLattice& lattice, TileId tile,
                                         int cell);

}  // namespace prairie
