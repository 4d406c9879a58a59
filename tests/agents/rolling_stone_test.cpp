#include "agents/rolling_stone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace prairie {
namespace {

TEST(RollingStone, RollsToTheEndOfItsWayAndLies) {
  const HeightField level;
  RollingStone stone;
  stone.start_m = {3.0, 4.0};
  stone.heading_rad = 0.7;
  stone = rolled_on(stone, 0.5);
  EXPECT_NEAR(glm::distance(place_of(stone, level).contact_m, stone.start_m), 1.0, 1e-6);
  for (int n = 0; n < 1000; ++n) stone = rolled_on(stone, 0.1);
  EXPECT_EQ(stone.rolled_m, stone.most_way_m);
  EXPECT_NEAR(place_of(stone, level).centre_m.z, stone.radius_m, 1e-9);
  EXPECT_EQ(rolled_on(stone, 1.0).rolled_m, stone.rolled_m);
}

TEST(RollingStone, TurnsAsFarAsItRolls) {
  RollingStone stone;
  stone.rolled_m = 0.25 * 2.0 * 3.141592653589793 * stone.radius_m;
  const MoverPlace quarter = place_of(stone, HeightField());
  EXPECT_NEAR(quarter.axes[0].z, -1.0, 1e-5) << "what was ahead is below";
}

TEST(RollingStone, TakesNoTimeThatIsNone) {
  const RollingStone stone;
  for (const double dt_s : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(rolled_on(stone, dt_s).rolled_m, 0.0) << dt_s;
  EXPECT_EQ(rolled_on(stone, std::numeric_limits<double>::infinity()).rolled_m, stone.most_way_m);
}

}  // namespace
}  // namespace prairie
