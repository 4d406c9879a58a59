// Prepared cells (generator/cell_table.h) of the tiles around the eye, kept from frame to frame. Which cells
// it holds never shows in a picture: a cell is a pure function of the meadow.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "generator/cell_table.h"

namespace prairie {

class CellCache {
 public:
  explicit CellCache(const Meadow& meadow);

  /// The cell's species and their tables; valid until the next `end_frame`.
  const CellTables& get(TileId tile, int cell);

  /// Forgets cells that several frames have not asked for.
  void end_frame();

  const PlantingLattice& lattice() const { return lattice_; }

 private:
  struct Entry {
    CellTables tables;
    std::uint64_t last_frame = 0;
  };
  const Meadow* meadow_;
  PlantingLattice lattice_;
  std::unordered_map<std::uint64_t, Entry> entries_;
  std::uint64_t frame_ = 0;
};

}  // namespace prairie
