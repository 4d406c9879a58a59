#include "generator/plant.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <xxhash.h>

#include "generator/cell_table.h"
#include "generator/plant_cell.h"

namespace prairie {
namespace {

CellTables tile_tables(const Meadow& meadow, const PlantingLattice& lattice, TileId tile) {
  CellTables tables;
  for (int cell = 0; cell < kCellsPerTile; ++cell) append_cell(meadow, lattice, tile, cell, tables);
  return tables;
}

std::uint64_t hash_of(const std::vector<Blade>& blades) {
  return XXH3_64bits(blades.data(), blades.size() * sizeof(Blade));
}

std::vector<Blade> plant_tile(const Meadow& meadow, const PlantingLattice& lattice, TileId tile) {
  const CellTables tables = tile_tables(meadow, lattice, tile);
  std::vector<Blade> blades;
  std::size_t count = 0;
  for (const PlantedCell& cell : tables.cells) count += cell.planted;
  blades.resize(count);
  std::size_t next = 0;
  for (std::uint32_t s = 0; s < meadow.species.size(); ++s) {
    for (const PlantedCell& cell : tables.cells) {
      if (cell.species != s) continue;
      plant_cell(cell, meadow.species[s].species.params, tables.tables,
                 std::span(blades).subspan(next, cell.planted));
      next += cell.planted;
    }
  }
  return blades;
}

}  // namespace

std::vector<Blade> plant_tile(const Meadow& meadow, TileId tile) {
  return plant_tile(meadow, PlantingLattice(meadow), tile);
}

std::uint64_t tile_hash(const Meadow& meadow, TileId tile) {
  return hash_of(plant_tile(meadow, tile));
}

std::vector<std::uint64_t> tile_hashes(const Meadow& meadow, const TileRange& tiles) {
  const PlantingLattice lattice(meadow);
  const int columns = tiles.last.i - tiles.first.i + 1;
  std::vector<std::uint64_t> hashes(static_cast<std::size_t>(tiles.count()));
  oneapi::tbb::parallel_for(
      oneapi::tbb::blocked_range<std::int64_t>(0, tiles.count()), [&](const auto& range) {
        for (std::int64_t n = range.begin(); n != range.end(); ++n) {
          const TileId tile{tiles.first.i + static_cast<int>(n % columns),
                            tiles.first.j + static_cast<int>(n / columns)};
          hashes[static_cast<std::size_t>(n)] = hash_of(plant_tile(meadow, lattice, tile));
        }
      });
  return hashes;
}

std::uint64_t planted_count(const Meadow& meadow, TileId tile) {
  std::uint64_t count = 0;
  for (const PlantedCell& cell : tile_tables(meadow, PlantingLattice(meadow), tile).cells)
    count += cell.planted;
  return count;
}

std::vector<double> expected_counts(const Meadow& meadow, TileId tile) {
  const PlantingLattice lattice(meadow);
  std::vector<double> counts(meadow.species.size(), 0.0);
  for (int cell = 0; cell < kCellsPerTile; ++cell) {
    const std::vector<double> of_cell = expected_cell_counts(meadow, lattice, tile, cell);
    for (std::size_t s = 0; s < counts.size(); ++s) counts[s] += of_cell[s];
  }
  return counts;
}

}  // namespace prairie
