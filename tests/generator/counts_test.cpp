// Counts without blades: what `planted_count` and `expected_counts` promise of `plant_tile`.
#include <gtest/gtest.h>

#include <cmath>

#include "generator/blade_identity.h"
#include "generator/plant.h"
#include "tests/generator/reference_density.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr double kExtentM = 40.0;

TEST(CountsTest, PlantedCountIsWhatIsPlanted) {
  const Meadow meadow = rich_meadow(16.0);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(planted_count(meadow, {i, j}), plant_tile(meadow, {i, j}).size());
    }
  }
}

/// Each cell rounds its expectation by less than one blade.
TEST(CountsTest, CountDiffersFromItsExpectationByLessThanOneACell) {
  const Meadow meadow = rich_meadow(kExtentM);
  double planted = 0.0, expected = 0.0, cells = 0.0;
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      double of_tile = 0.0;
      for (const double count : expected_counts(meadow, {i, j})) of_tile += count;
      const auto count = static_cast<double>(planted_count(meadow, {i, j}));
      const double rounded = static_cast<double>(kCellsPerTile * meadow.species.size());
      EXPECT_LT(std::abs(count - of_tile), rounded);
      planted += count;
      expected += of_tile;
      cells += rounded;
    }
  }
  // Rounding errors are independent, of variance at most 1/4.
  EXPECT_LE(std::abs(planted - expected), 4.0 * std::sqrt(0.25 * cells));
}

TEST(CountsTest, ExpectationIsTheIntegralOfTheMap) {
  for (const NodeGrid& density : {uniform_density(123.0), smooth_density(kExtentM, 200.0),
                                  steep_density(kExtentM, 200.0), quarter_metre_density(kExtentM, 200.0)}) {
    const Meadow meadow = level_meadow(kExtentM, density);
    for (int n = 0; n < 10; ++n) {
      const TileId tile{n, (3 * n) % 10};
      const glm::dvec2 origin_m = tile_origin_m(meadow, tile);
      const double integral = density_integral(density, origin_m, origin_m + meadow.tile_m);
      EXPECT_NEAR(expected_counts(meadow, tile)[0], integral, 1e-6 * integral);
    }
  }
}

/// A cell that expects a third of a blade has one in a third of all worlds: 30 000 give a standard deviation
/// of 0.0027.
TEST(CountsTest, RareBladesComeAsOftenAsTheyShould) {
  Meadow meadow = level_meadow(4.0, uniform_density(1.0 / 12.0));
  double blades = 0.0;
  constexpr int kSeeds = 7500;
  for (int seed = 0; seed < kSeeds; ++seed) {
    meadow.seed = static_cast<std::uint64_t>(seed);
    blades += static_cast<double>(planted_count(meadow, {0, 0}));
  }
  EXPECT_NEAR(blades / (4.0 * kSeeds), 1.0 / 3.0, 0.012);
}

TEST(CountsTest, IdentitiesCountUpInEachCell) {
  const Meadow meadow = rich_meadow(8.0);
  std::uint32_t previous = 0xffffffffu;
  for (const Blade& blade : plant_tile(meadow, {1, 1})) {
    const std::uint32_t index = blade.identity & 0xffffffu;
    EXPECT_TRUE(index == 0 || blade.identity == previous + 1) << index;
    EXPECT_LT(identity_of(blade).species, meadow.species.size());
    previous = blade.identity;
  }
}

}  // namespace
}  // namespace prairie
