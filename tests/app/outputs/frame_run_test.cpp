#include "app/outputs/frame_run.h"

#include <gtest/gtest.h>

#include "app/terminal/usage_error.h"
#include "tests/world/scene_texts.h"

namespace prairie {
namespace {

TEST(FrameCount, IsAtLeastOneAndRoundsToWholeFrames) {
  EXPECT_EQ(frame_count(0.0, FrameRate{30}, 100), 1);
  EXPECT_EQ(frame_count(1.0, FrameRate{30}, 100), 30);
  EXPECT_EQ(frame_count(0.99, FrameRate{30}, 100), 30);
  EXPECT_EQ(frame_count(10.0, FrameRate{10}, 100), 100);
}

TEST(FrameCount, IsBounded) {
  EXPECT_THROW(frame_count(10.1, FrameRate{10}, 100), UsageError);
  EXPECT_THROW(frame_count(1e30, FrameRate{240}, kMostUndrawnFrames), UsageError);
}

TEST(FrameRun, WithoutOutputsGoesOnToTheEndOfTheLastFrame) {
  World world(parse_scene(testing::kPlainScene, "folder", {}), {});
  Progress progress("step", 30, true);
  run_frames(world, 30, FrameRate{10}, {}, progress);
  EXPECT_NEAR(world.time_s(), 3.0, 1e-9);
}

}  // namespace
}  // namespace prairie
