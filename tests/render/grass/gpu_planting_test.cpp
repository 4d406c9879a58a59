// The compute shader plants what the CPU plants: bit for bit on Mesa's software renderer, whose +, −, ×, ÷
// and √ are the CPU's; elsewhere the same blades in the same order, with roots within 0.1 mm.
#include "render/grass/gpu_planting.h"

#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "generator/cell_table.h"
#include "generator/plant_cell.h"
#include "tests/generator/test_meadow.h"
#include "tests/render/headless_test.h"

namespace prairie {
namespace {

class GpuPlantingTest : public HeadlessTest {
 protected:
  /// Plants the tiles' cells on both sides and compares them; returns how many blades there were.
  std::size_t compare(const Meadow& meadow, const TileRange& tiles) {
    const PlantingLattice lattice(meadow);
    CellTables tables;
    for (int j = tiles.first.j; j <= tiles.last.j; ++j) {
      for (int i = tiles.first.i; i <= tiles.last.i; ++i) {
        for (int cell = 0; cell < kCellsPerTile; ++cell) append_cell(meadow, lattice, {i, j}, cell, tables);
      }
    }
    std::vector<SpeciesParams> species;
    for (const PlantedSpecies& planted : meadow.species) species.push_back(planted.species.params);
    std::vector<Blade> expected;
    for (const PlantedCell& cell : tables.cells) {
      std::vector<Blade> blades(cell.planted);
      plant_cell(cell, species[cell.species], tables.tables, blades);
      expected.insert(expected.end(), blades.begin(), blades.end());
    }
    GpuPlanting planting(PRAIRIE_TEST_SHADERS);
    planting.prepare(tables, species);
    planting.plant();
    expect_same(expected, planting.read_back());
    return expected.size();
  }

 private:
  static void expect_same(const std::vector<Blade>& expected, const std::vector<Blade>& blades) {
    ASSERT_EQ(blades.size(), expected.size());
    if (on_llvmpipe()) {
      ASSERT_EQ(std::memcmp(blades.data(), expected.data(), blades.size() * sizeof(Blade)), 0)
          << first_difference(expected, blades);
    }
    double farthest_m = 0.0;
    for (std::size_t n = 0; n < blades.size(); ++n) {
      ASSERT_EQ(blades[n].identity, expected[n].identity);
      farthest_m =
          std::max(farthest_m, static_cast<double>(std::hypot(blades[n].root_m.x - expected[n].root_m.x,
                                                              blades[n].root_m.y - expected[n].root_m.y)));
      farthest_m =
          std::max(farthest_m, static_cast<double>(std::abs(blades[n].ground_m - expected[n].ground_m)));
      ASSERT_NEAR(blades[n].height_m, expected[n].height_m, 1e-3f * expected[n].height_m);
      ASSERT_NEAR(blades[n].azimuth_rad, expected[n].azimuth_rad, 1e-5f);
    }
    EXPECT_LE(farthest_m, 1e-4);
  }

  static std::string first_difference(const std::vector<Blade>& expected, const std::vector<Blade>& blades) {
    for (std::size_t n = 0; n < blades.size(); ++n) {
      float a[16], b[16];
      std::memcpy(a, &expected[n], sizeof(Blade));
      std::memcpy(b, &blades[n], sizeof(Blade));
      for (int word = 0; word < 16; ++word) {
        if (std::memcmp(&a[word], &b[word], sizeof(float)) == 0) continue;
        return "blade " + std::to_string(n) + ", word " + std::to_string(word) + ": " +
               std::to_string(a[word]) + " on the CPU, " + std::to_string(b[word]) + " on the GPU";
      }
    }
    return "no difference";
  }
};

constexpr double kExtentM = 16.0;

TEST_F(GpuPlantingTest, PlantsTheSameForEveryLatticeOfDensities) {
  for (const double spacing_m : {4.0, 2.0, 1.0, 0.5, 0.25}) {
    const NodeGrid density = grid_from(square_frame(kExtentM, spacing_m), [](glm::dvec2 p) {
      return 600.0 * unit_noise(51, std::lround(4.0 * p.x), std::lround(4.0 * p.y));
    });
    EXPECT_GT(compare(level_meadow(kExtentM, density), {{0, 0}, {3, 3}}), 20000u) << spacing_m;
  }
  EXPECT_GT(compare(level_meadow(kExtentM, uniform_density(300.0)), {{0, 0}, {3, 3}}), 20000u);
}

TEST_F(GpuPlantingTest, PlantsTheSameOnSteepGroundWithFeatures) {
  EXPECT_GT(compare(rich_meadow(kExtentM), {{0, 0}, {3, 3}}), 50000u);
}

TEST_F(GpuPlantingTest, PlantsTheSameWhereDensityHasHolesAndEnds) {
  const NodeGrid density = grid_from(square_frame(kExtentM, 0.5), [](glm::dvec2 p) {
    const double noise = unit_noise(52, std::lround(2.0 * p.x), std::lround(2.0 * p.y));
    return noise < 0.15 ? std::nan("") : noise < 0.5 ? 0.0 : 900.0 * noise;
  });
  EXPECT_GT(compare(level_meadow(kExtentM, density), {{0, 0}, {3, 3}}), 10000u);
  EXPECT_GT(compare(level_meadow(9.1, uniform_density(300.0)), {{0, 0}, {2, 2}}), 10000u);
}

TEST_F(GpuPlantingTest, PlantsTheSameFarAway) {
  Meadow meadow = rich_meadow(kExtentM);
  meadow.repeats = true;
  for (NodeGrid* map : {&meadow.blade_height, &meadow.bend}) *map = NodeGrid::uniform(1.2f);
  for (PlantedSpecies& species : meadow.species) species.density_per_m2 = uniform_density(100.0);
  meadow.color.reset();
  meadow.ground = HeightField();
  EXPECT_GT(compare(meadow, {{100000, -70000}, {100002, -69998}}), 10000u);
}

TEST_F(GpuPlantingTest, PlantsTheSameForManySeedsAndFewBlades) {
  Meadow meadow = level_meadow(kExtentM, smooth_density(kExtentM, 0.3));
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    meadow.seed = seed * 0x123456789abcdefull;
    EXPECT_GT(compare(meadow, {{0, 0}, {3, 3}}), 20u);
  }
}

}  // namespace
}  // namespace prairie
