#include "app/viewer/frame_times.h"

#include <gtest/gtest.h>

namespace prairie {
namespace {

TEST(FrameTimes, MedianOfTheLastFrames) {
  FrameTimes times;
  EXPECT_EQ(times.median_ms(), 0.0);
  times.add(5.0);
  EXPECT_EQ(times.median_ms(), 5.0);
  for (int frame = 0; frame < 100; ++frame) times.add(frame % 10 == 0 ? 900.0 : 16.0);
  EXPECT_EQ(times.median_ms(), 16.0);
  for (int frame = 0; frame < 60; ++frame) times.add(8.0);
  EXPECT_EQ(times.median_ms(), 8.0);
}

}  // namespace
}  // namespace prairie
