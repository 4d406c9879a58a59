#include "generator/surface_density.h"

#include <gtest/gtest.h>

#include <cmath>

#include "generator/blade_census.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

TEST(SurfaceDensity, CountsTheGroundsOwnSquareMetres) {
  // A plane of slope 0.75: 1.25 m² of surface on each of map.
  Meadow meadow = level_meadow(40.0, uniform_density(200.0));
  meadow.ground =
      HeightField(grid_from(square_frame(40.0, 1.0), [](glm::dvec2 at) { return 0.6 * at.x + 0.45 * at.y; }));
  const double per_map = blade_census(meadow).blades[0];
  for (const NodeGrid& density :
       {uniform_density(200.0), grid_from(square_frame(40.0, 0.5), [](glm::dvec2) { return 200.0; }),
        grid_from(square_frame(40.0, 8.0), [](glm::dvec2) { return 200.0; })}) {
    meadow.species[0].density_per_m2 = density_per_map(density, meadow.ground);
    // Beyond the border the ground is level across it.
    EXPECT_NEAR(meadow.species[0].density_per_m2.sample({20.0, 20.0}), 250.0f, 1e-3f);
    EXPECT_NEAR(blade_census(meadow).blades[0], 1.25 * per_map, 0.03 * per_map);
  }
}

TEST(SurfaceDensity, LevelGroundChangesNothing) {
  EXPECT_TRUE(density_per_map(uniform_density(200.0), HeightField()).is_uniform());
}

}  // namespace
}  // namespace prairie
