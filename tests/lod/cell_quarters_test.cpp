// Quarters of cells hold every blade once, and know where their blades stand.
#include "lod/cell_quarters.h"

#include <gtest/gtest.h>

#include "generator/plant_cell.h"
#include "shaders/kernels/kernels.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr double kExtentM = 40.0;

void expect_quarters(const Meadow& meadow) {
  const PlantingLattice lattice(meadow);
  Kernels kernels;
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      CellTables tables;
      append_cell(meadow, lattice, {i, j}, (i + j) % kCellsPerTile, tables);
      for (const PlantedCell& cell : tables.cells) {
        std::vector<Blade> blades(cell.planted);
        plant_cell(cell, meadow.species[cell.species].species.params, tables.tables, blades);
        std::vector<int> seen(cell.planted, 0);
        for (const CellQuarter& quarter : quarters_of(cell, tables.tables)) {
          const std::uint32_t count = drawn_in_quarter(quarter.code, cell.planted);
          for (std::uint32_t n = 0; n < count; ++n) {
            const std::uint32_t k = kernels.quarter_index(quarter.code, n);
            ASSERT_LT(k, cell.planted);
            ++seen[k];
            const glm::vec2 root_m = blades[k].root_m - cell.offset_m;
            ASSERT_GE(root_m.x, quarter.min_m.x);
            ASSERT_GE(root_m.y, quarter.min_m.y);
            ASSERT_LE(root_m.x, quarter.max_m.x);
            ASSERT_LE(root_m.y, quarter.max_m.y);
          }
        }
        for (const int times : seen) ASSERT_EQ(times, 1);
      }
    }
  }
}

TEST(CellQuartersTest, HoldEveryBladeOnceWhereTheySay) {
  expect_quarters(level_meadow(kExtentM, uniform_density(300.0)));
  expect_quarters(rich_meadow(kExtentM));
}

TEST(CellQuartersTest, HoldWhereTheDensityVaries) {
  for (const double spacing_m : {0.25, 0.5, 1.0, 4.0}) {
    expect_quarters(level_meadow(kExtentM, grid_from(square_frame(kExtentM, spacing_m), [&](glm::dvec2 p) {
                                   const double noise = unit_noise(5, std::lround(p.x / spacing_m),
                                                                   std::lround(p.y / spacing_m));
                                   return noise > 0.3 ? 600.0 * noise : 0.0;
                                 })));
  }
}

TEST(CellQuartersTest, PrefixesSplitIntoQuarters) {
  for (std::uint32_t drawn = 0; drawn < 500; ++drawn) {
    std::uint32_t sum = 0;
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter) sum += drawn_in_quarter(4u + quarter, drawn);
    ASSERT_EQ(sum, drawn);
  }
}

}  // namespace
}  // namespace prairie
