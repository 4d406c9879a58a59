// Density: what stands on a square is what the maps say, on average over seeds and in every single field.
//
// Over 1000 seeds the mean count of each 1/16 of a tile lies within 0.5 % of the integral of the density. The
// standard error of each mean is measured alongside and has to stay below a quarter of that margin, so that
// the test judges the planting and not its own luck. The integral is the map's own
// (tests/generator/reference_density.h), not that of the lattice that planting makes of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "generator/plant.h"
#include "tests/generator/reference_density.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr int kSide = 4;  // a tile in 4 × 4 squares
constexpr double kMeanTolerance = 0.005;

using SquareCounts = std::array<double, kSide * kSide>;

SquareCounts counts_in_squares(const Meadow& meadow, TileId tile) {
  SquareCounts counts{};
  const auto square = [&](float x_m) {
    return std::min(static_cast<int>(static_cast<double>(x_m) / meadow.tile_m * kSide), kSide - 1);
  };
  for (const Blade& blade : plant_tile(meadow, tile)) {
    counts[static_cast<std::size_t>(kSide * square(blade.root_m.y) + square(blade.root_m.x))] += 1.0;
  }
  return counts;
}

SquareCounts integrals_over_squares(const Meadow& meadow, TileId tile) {
  SquareCounts integrals{};
  const double side_m = meadow.tile_m / kSide;
  for (int n = 0; n < kSide * kSide; ++n) {
    const glm::dvec2 min_m = tile_origin_m(meadow, tile) + side_m * glm::dvec2(n % kSide, n / kSide);
    integrals[static_cast<std::size_t>(n)] =
        density_integral(meadow.species[0].density_per_m2, min_m, min_m + side_m);
  }
  return integrals;
}

struct Deviation {
  double mean = 0.0;            // largest |mean count / integral − 1|
  double standard_error = 0.0;  // largest of such a mean, relative
};

Deviation deviation_over_seeds(Meadow meadow, int seeds) {
  Deviation worst;
  const TileRange tiles = tiles_of(meadow);
  for (int j = tiles.first.j; j <= tiles.last.j; ++j) {
    for (int i = tiles.first.i; i <= tiles.last.i; ++i) {
      SquareCounts sum{}, squares{};
      for (int seed = 0; seed < seeds; ++seed) {
        meadow.seed = static_cast<std::uint64_t>(seed);
        const SquareCounts counts = counts_in_squares(meadow, {i, j});
        for (std::size_t n = 0; n < counts.size(); ++n) {
          sum[n] += counts[n];
          squares[n] += counts[n] * counts[n];
        }
      }
      const SquareCounts integrals = integrals_over_squares(meadow, {i, j});
      for (std::size_t n = 0; n < sum.size(); ++n) {
        const double mean = sum[n] / seeds;
        const double variance = std::max(squares[n] / seeds - mean * mean, 0.0);
        worst.mean = std::max(worst.mean, std::abs(mean / integrals[n] - 1.0));
        worst.standard_error = std::max(worst.standard_error, std::sqrt(variance / seeds) / integrals[n]);
      }
    }
  }
  return worst;
}

void expect_mean_density(const std::string& name, NodeGrid density, int seeds,
                         double tolerance = kMeanTolerance) {
  const Deviation worst = deviation_over_seeds(level_meadow(8.0, std::move(density)), seeds);
  std::printf("%-14s mean within %.3f %%, standard error %.3f %%\n", name.c_str(), 100.0 * worst.mean,
              100.0 * worst.standard_error);
  EXPECT_LE(worst.standard_error, 0.25 * kMeanTolerance) << name;
  EXPECT_LE(worst.mean, tolerance) << name;
}

/// Nodes that lie on no lattice of cells: 0.7 m apart, off the origin, changing from node to node at random.
NodeGrid misaligned_density(double mean_per_m2) {
  const GridFrame frame{15, 15, 0.7, {-0.33, -0.21}, false};
  return grid_from(frame, [&](glm::dvec2 p) {
    return mean_per_m2 * (0.4 + 1.2 * unit_noise(17, std::lround(100.0 * p.x), std::lround(100.0 * p.y)));
  });
}

/// Finer than any lattice of cells.
NodeGrid tenth_metre_density(double mean_per_m2) {
  return grid_from(square_frame(8.0, 0.1), [&](glm::dvec2 p) {
    return mean_per_m2 * (0.4 + 1.2 * unit_noise(18, std::lround(10.0 * p.x), std::lround(10.0 * p.y)));
  });
}

TEST(DensityTest, MeanOverSeedsIsTheIntegralUniform) {
  expect_mean_density("uniform", uniform_density(300.0), 1000);
}
TEST(DensityTest, MeanOverSeedsIsTheIntegralSmooth) {
  expect_mean_density("smooth", smooth_density(8.0, 300.0), 1000);
}
TEST(DensityTest, MeanOverSeedsIsTheIntegralSteep) {
  expect_mean_density("steep", steep_density(8.0, 300.0), 1000);
}
TEST(DensityTest, MeanOverSeedsIsTheIntegralQuarterMetre) {
  expect_mean_density("0.25 m", quarter_metre_density(8.0, 300.0), 1000);
}
/// Maps whose nodes lie on no lattice of the cells are resampled (generator/cell_lattice.h), which blurs
/// nodes that change at random from one to the next, the worst that a map can do; 2.1 % and 4.2 % of a square
/// were measured.
constexpr double kResampledTolerance = 0.05;

TEST(DensityTest, MeanOverSeedsIsNearTheIntegralMisaligned) {
  expect_mean_density("0.7 m offset", misaligned_density(300.0), 1000, kResampledTolerance);
}
TEST(DensityTest, MeanOverSeedsIsNearTheIntegralFinerThanTheLattice) {
  expect_mean_density("0.1 m", tenth_metre_density(300.0), 1000, kResampledTolerance);
}
/// 308 blades a tile, 77 = 4 · 19 + 1 a cell: shows whether the sequence's odd points prefer a place.
TEST(DensityTest, MeanOverSeedsIsTheIntegralSparse) {
  expect_mean_density("sparse", uniform_density(77.0 / 4.0), 4000);
}
TEST(DensityLongTest, MeanOverManySeedsIsTheIntegral) {
  expect_mean_density("smooth", smooth_density(8.0, 500.0), 10000);
  expect_mean_density("steep", steep_density(8.0, 500.0), 10000);
  expect_mean_density("0.25 m", quarter_metre_density(8.0, 500.0), 10000);
  for (const double blades_per_cell : {75.0, 75.5, 76.0, 77.0, 78.0, 79.0, 96.0, 101.0}) {
    expect_mean_density("sparse", uniform_density(blades_per_cell / 4.0), 20000);
  }
}

/// χ² of the counts in all 1/16s of a field, over their number: 1 for blades that are thrown at random; the
/// bar is 0.3.
void expect_even_field(const std::string& name, NodeGrid density, double extent_m) {
  const Meadow meadow = level_meadow(extent_m, std::move(density));
  const TileRange tiles = tiles_of(meadow);
  double chi_squared = 0.0, planted = 0.0, integral = 0.0, fewest = 1e30;
  for (int j = tiles.first.j; j <= tiles.last.j; ++j) {
    for (int i = tiles.first.i; i <= tiles.last.i; ++i) {
      const SquareCounts counts = counts_in_squares(meadow, {i, j});
      const SquareCounts integrals = integrals_over_squares(meadow, {i, j});
      double of_tile = 0.0;
      for (std::size_t n = 0; n < counts.size(); ++n) {
        chi_squared += (counts[n] - integrals[n]) * (counts[n] - integrals[n]) / integrals[n];
        of_tile += counts[n];
        integral += integrals[n];
      }
      planted += of_tile;
      fewest = std::min(fewest, of_tile);
    }
  }
  const double per_square = chi_squared / static_cast<double>(kSide * kSide * tiles.count());
  const double total = planted / integral - 1.0;
  std::printf("%-8s chi2/df %.3f, total %+.4f %%, at least %.0f blades a tile\n", name.c_str(), per_square,
              100.0 * total, fewest);
  EXPECT_GE(fewest, 300.0) << name;
  EXPECT_LE(per_square, 0.3) << name;
  EXPECT_LE(std::abs(total), 0.001) << name;
}

// As few blades a tile as the bar allows: with more, χ² only falls.
TEST(DensityTest, SingleFieldIsEvenerThanChance) {
  expect_even_field("uniform", uniform_density(19.0), 80.0);
  expect_even_field("smooth", smooth_density(80.0, 48.0), 80.0);
  expect_even_field("steep", steep_density(80.0, 30.0), 80.0);
  expect_even_field("0.25 m", quarter_metre_density(80.0, 21.0), 80.0);
}

}  // namespace
}  // namespace prairie
