// Thinning a cell draws a prefix of its blades, so prefixes have to be well spread: for the first 10, 37, 50
// and 70 % of a cell's blades the largest empty circle is at most 0.9 times that of random subsets of the
// same size, on average over 100 cells of about 300 blades. On uniform ground circles are measured on a
// torus, where every place is like every other; where density varies, inside the cell alone. Both sets of
// blades are measured alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "generator/plant.h"
#include "tests/generator/empty_circle.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr double kBar = 0.9;
constexpr double kShares[] = {0.10, 0.37, 0.50, 0.70};
constexpr int kRandomSubsets = 3;

/// The roots of a tile's first cell, in cell sides.
std::vector<glm::dvec2> cell_roots(const Meadow& meadow, TileId tile) {
  const double cell_m = meadow.tile_m / kCellsPerSide;
  std::vector<glm::dvec2> roots;
  for (const Blade& blade : plant_tile(meadow, tile)) {
    if (!roots.empty() && (blade.identity & 0xffffffu) == 0) break;
    roots.push_back(glm::dvec2(blade.root_m) / cell_m);
  }
  return roots;
}

using Circle = double (*)(std::span<const glm::dvec2>);

/// Mean circle of prefixes over mean circle of random subsets.
double relative_circle(const Meadow& meadow, int cells, double share, Circle circle) {
  std::mt19937 random(31);
  double prefixes = 0.0, subsets = 0.0;
  for (int n = 0; n < cells; ++n) {
    const std::vector<glm::dvec2> roots = cell_roots(meadow, {n % 16, n / 16});
    const auto count = static_cast<std::size_t>(std::lround(share * static_cast<double>(roots.size())));
    prefixes += circle(std::span(roots).first(count));
    for (int subset = 0; subset < kRandomSubsets; ++subset) {
      std::vector<glm::dvec2> some;
      std::sample(roots.begin(), roots.end(), std::back_inserter(some), count, random);
      subsets += circle(some) / kRandomSubsets;
    }
  }
  return prefixes / subsets;
}

void expect_even_prefixes(const char* name, NodeGrid density, int cells, Circle circle) {
  const Meadow meadow = level_meadow(64.0, std::move(density));
  for (const double share : kShares) {
    const double relative = relative_circle(meadow, cells, share, circle);
    std::printf("%-8s first %2.0f %%: %.3f\n", name, 100.0 * share, relative);
    EXPECT_LE(relative, kBar) << name << ", first " << share;
  }
}

TEST(PrefixesTest, AreWellSpreadOnUniformGround) {
  expect_even_prefixes("uniform", uniform_density(75.0), 100, largest_empty_circle);
}

TEST(PrefixesTest, AreWellSpreadOnSmoothGround) {
  expect_even_prefixes("smooth", smooth_density(64.0, 75.0), 100, largest_empty_circle_in_square);
}

TEST(PrefixesLongTest, AreWellSpreadForManyCellsAndDensities) {
  for (const double per_m2 : {20.0, 61.0, 250.0}) {
    expect_even_prefixes("uniform", uniform_density(per_m2), 250, largest_empty_circle);
    expect_even_prefixes("smooth", smooth_density(64.0, per_m2), 250, largest_empty_circle_in_square);
  }
}

TEST(EmptyCircleTest, FindsTheLargest) {
  // On a torus a lattice of k × k points leaves circles of half its diagonal.
  std::vector<glm::dvec2> lattice;
  for (int n = 0; n < 25; ++n) lattice.push_back({0.013 + 0.2 * (n % 5), 0.027 + 0.2 * (n / 5)});
  EXPECT_NEAR(largest_empty_circle(lattice), 0.1 * std::sqrt(2.0), 1e-3);
  lattice.erase(lattice.begin() + 12);
  EXPECT_NEAR(largest_empty_circle(lattice), 0.2, 1e-3);
  const std::vector<glm::dvec2> corner{{0.0, 0.0}};
  EXPECT_NEAR(largest_empty_circle_in_square(corner), std::sqrt(2.0), 1e-3);
}

}  // namespace
}  // namespace prairie
