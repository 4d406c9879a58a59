// The same meadow gives the same blades: for any number of threads, in whichever order tiles are planted,
// through either way into the kernels, and on every machine. (tests/generator/hash_matrix.sh compares
// compilers.)
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <bit>
#include <cstring>
#include <set>

#include "generator/cell_table.h"
#include "generator/plant.h"
#include "generator/plant_cell.h"
#include "shaders/kernels/kernels.h"
#include "tests/generator/hashed_meadow.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

std::vector<std::uint64_t> hashes_with_threads(const Meadow& meadow, int threads) {
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                          static_cast<std::size_t>(threads));
  oneapi::tbb::task_arena arena(threads);
  std::vector<std::uint64_t> hashes;
  arena.execute([&] { hashes = tile_hashes(meadow, tiles_of(meadow)); });
  return hashes;
}

TEST(DeterminismTest, HashesDoNotDependOnThreads) {
  const Meadow meadow = rich_meadow(48.0);
  const std::vector<std::uint64_t> alone = hashes_with_threads(meadow, 1);
  EXPECT_EQ(alone.size(), 144u);
  EXPECT_EQ(std::set<std::uint64_t>(alone.begin(), alone.end()).size(), alone.size());
  EXPECT_EQ(hashes_with_threads(meadow, 2), alone);
  EXPECT_EQ(hashes_with_threads(meadow, 7), alone);
}

TEST(DeterminismTest, HashesComeByRowThenColumn) {
  const Meadow meadow = rich_meadow(16.0);
  const TileRange range{{1, 0}, {3, 2}};
  const std::vector<std::uint64_t> hashes = tile_hashes(meadow, range);
  std::size_t n = 0;
  for (int j = 0; j <= 2; ++j) {
    for (int i = 1; i <= 3; ++i) EXPECT_EQ(hashes[n++], tile_hash(meadow, {i, j}));
  }
}

/// The vectorised stages against the kernel that the compute shader runs, bit for bit.
TEST(DeterminismTest, StagesPlantWhatTheKernelPlants) {
  const Meadow meadow = rich_meadow(16.0);
  const PlantingLattice lattice(meadow);
  std::size_t compared = 0;
  for (int tile = 0; tile < 16; ++tile) {
    CellTables tables;
    for (int cell = 0; cell < kCellsPerTile; ++cell) {
      append_cell(meadow, lattice, {tile % 4, tile / 4}, cell, tables);
    }
    Kernels kernels{tables.tables.data()};
    for (const PlantedCell& cell : tables.cells) {
      const SpeciesParams& species = meadow.species[cell.species].species.params;
      std::vector<Blade> blades(cell.planted);
      plant_cell(cell, species, tables.tables, blades);
      for (std::uint32_t k = 0; k < cell.planted; ++k) {
        const auto root = kernels.plant_root(cell, k);
        const auto features = kernels.features_of(cell, kernels.root_in_cell(cell, root));
        const Blade blade = kernels.plant_blade(cell, species, features, root, k);
        ASSERT_EQ(std::memcmp(&blade, &blades[k], sizeof(Blade)), 0) << "blade " << k << " of tile " << tile;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 50000u);
}

TEST(DeterminismTest, APrefixOfACellIsTheCellsPrefix) {
  const Meadow meadow = rich_meadow(8.0);
  const PlantingLattice lattice(meadow);
  CellTables tables;
  append_cell(meadow, lattice, {1, 1}, 2, tables);
  for (const PlantedCell& cell : tables.cells) {
    const SpeciesParams& species = meadow.species[cell.species].species.params;
    std::vector<Blade> all(cell.planted);
    plant_cell(cell, species, tables.tables, all);
    for (const std::uint32_t count : {1u, 63u, 64u, 65u, cell.planted / 2}) {
      std::vector<Blade> some(std::min(count, cell.planted));
      plant_cell(cell, species, tables.tables, some);
      EXPECT_EQ(std::memcmp(some.data(), all.data(), some.size() * sizeof(Blade)), 0) << count;
    }
  }
}

TEST(DeterminismTest, SeedsGiveDifferentBlades) {
  Meadow meadow = rich_meadow(8.0);
  std::set<std::uint64_t> hashes;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    meadow.seed = seed;
    hashes.insert(tile_hash(meadow, {1, 0}));
    meadow.seed = seed << 40;
    hashes.insert(tile_hash(meadow, {1, 0}));
  }
  EXPECT_EQ(hashes.size(), 99u);
}

TEST(DeterminismTest, HashIsTheSameOnEveryMachine) {
  EXPECT_EQ(hashed_meadow_hash(), kHashedMeadowHash)
      << "planting has changed: if that is meant, put the new value into tests/generator/hashed_meadow.h";
}

}  // namespace
}  // namespace prairie
