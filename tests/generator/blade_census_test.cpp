// What `info` tells of a field against the expectations of all its tiles.
#include "generator/blade_census.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "generator/plant.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

std::vector<double> sum_over_tiles(const Meadow& meadow) {
  std::vector<double> sum(meadow.species.size(), 0.0);
  const TileRange tiles = tiles_of(meadow);
  for (int j = tiles.first.j; j <= tiles.last.j; ++j) {
    for (int i = tiles.first.i; i <= tiles.last.i; ++i) {
      const std::vector<double> of_tile = expected_counts(meadow, {i, j});
      for (std::size_t s = 0; s < sum.size(); ++s) sum[s] += of_tile[s];
    }
  }
  return sum;
}

void expect_agreement(const Meadow& meadow, double share) {
  const BladeCensus census = blade_census(meadow);
  const std::vector<double> expected = sum_over_tiles(meadow);
  ASSERT_EQ(census.blades.size(), expected.size());
  for (std::size_t s = 0; s < expected.size(); ++s)
    EXPECT_NEAR(census.blades[s], expected[s], share * expected[s]) << "species " << s;
}

TEST(BladeCensus, IsExactWhereNodesLieOnTheLattice) {
  for (const double spacing_m : {0.25, 0.5, 1.0, 2.0, 4.0, 20.0}) {
    SCOPED_TRACE(spacing_m);
    const NodeGrid density = grid_from(square_frame(40.0, spacing_m), [](glm::dvec2 at) {
      return 100.0 + 90.0 * unit_noise(3, std::lround(4.0 * at.x), std::lround(4.0 * at.y));
    });
    expect_agreement(level_meadow(40.0, density), 1e-6);
  }
  expect_agreement(level_meadow(40.0, uniform_density(123.0)), 1e-9);
  expect_agreement(rich_meadow(40.0), 1e-6);
}

TEST(BladeCensus, LeavesOutWhatHasNoDataAndWhereTheFieldEnds) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto gaps = [](glm::dvec2 at) { return at.x > 10.0 && at.x < 20.0 && at.y < 12.0; };
  Meadow meadow = level_meadow(
      40.0, grid_from(square_frame(40.0, 1.0), [&](glm::dvec2 at) { return gaps(at) ? kNaN : 50.0 + at.x; }));
  expect_agreement(meadow, 1e-6);
  meadow.ground = HeightField(grid_from(square_frame(40.0, 0.5), [](glm::dvec2 at) {
    return std::hypot(at.x - 25.0, at.y - 30.0) < 6.0 ? kNaN : 0.1 * at.x;
  }));
  expect_agreement(meadow, 1e-6);
  meadow.extent_m = {33.0, 17.5};
  expect_agreement(meadow, 1e-6);
}

TEST(BladeCensus, IsNearWhereNodesLieElsewhere) {
  const GridFrame frame{
      .columns = 60, .rows = 60, .spacing_m = 0.73, .origin_m = {-0.4, -0.9}, .repeats = false};
  expect_agreement(level_meadow(40.0, grid_from(frame,
                                                [](glm::dvec2 at) {
                                                  return 100.0 +
                                                         50.0 * std::sin(0.3 * at.x) * std::cos(0.2 * at.y);
                                                })),
                   2e-3);
}

TEST(BladeCensus, CostsByTheNodesAndNotByTheArea) {
  // 1.6 thousand million tiles.
  const GridFrame frame = square_frame(160'000.0, 400.0);
  const auto start = std::chrono::steady_clock::now();
  const BladeCensus census =
      blade_census(level_meadow(160'000.0, grid_from(frame, [](glm::dvec2) { return 10.0; })));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_NEAR(census.blades[0], 10.0 * 160'000.0 * 160'000.0, 1e-6 * census.blades[0]);
  EXPECT_NEAR(census.densest_per_m2, 10.0, 1e-5);
  EXPECT_LT(elapsed.count(), 5.0) << "tile by tile it takes hours";
}

}  // namespace
}  // namespace prairie
