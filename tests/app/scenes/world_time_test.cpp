#include "app/scenes/world_time.h"

#include <gtest/gtest.h>

#include "app/scenes/open_world.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"
#include "world/world.h"

namespace prairie {
namespace {

TEST(WorldTime, AreEvenAndNoLongerThanASixtieth) {
  EXPECT_EQ(steps_in(0.0), 0);
  EXPECT_EQ(steps_in(-1.0), 0);
  EXPECT_EQ(steps_in(1.0 / 240.0), 1);
  for (const int frames_per_s : {1, 7, 24, 25, 30, 48, 60, 120})
    EXPECT_EQ(steps_in(1.0 / frames_per_s), (60 + frames_per_s - 1) / frames_per_s) << frames_per_s;
}

TEST(WorldTime, EndWhereTheyShould) {
  const TemporaryFolder folder;
  testing::write_small_scene(folder.path());
  World world = open_world(folder.path(), {});
  for (int frame = 0; frame <= 50; ++frame) {
    advance_to(world, frame / 24.0);
    EXPECT_NEAR(world.time_s(), frame / 24.0, 1e-4);
  }
  advance_to(world, 1.0);
  EXPECT_GT(world.time_s(), 2.0) << "time goes on only";
}

}  // namespace
}  // namespace prairie
