// GPU times: none before the device is done, sums of a frame's intervals, 0 where a stage did nothing.
#include "render/gl/gpu_timer.h"

#include <chrono>

#include "render/gl/render_target.h"
#include "tests/render/headless_test.h"

namespace prairie {
namespace {

constexpr glm::ivec2 kSizePx{1024, 1024};

using GpuTimerTest = HeadlessTest;

void work(const RenderTarget& target) {
  for (int n = 0; n < 8; ++n) target.begin();
}

TEST_F(GpuTimerTest, TellsTheTimeOfAFrameLater) {
  const RenderTarget target(kSizePx, false);
  GpuTimer timer;
  EXPECT_EQ(timer.last_ms(), 0.0);
  for (int frame = 0; frame < 4; ++frame) {
    timer.begin();
    work(target);
    timer.end();
    timer.finish_frame();
    if (frame == 0) {
      EXPECT_EQ(timer.last_ms(), 0.0) << "read in the frame in which it was made";
    }
    glFinish();
  }
  EXPECT_GT(timer.last_ms(), 0.0);
  EXPECT_LT(timer.last_ms(), 10'000.0);
}

TEST_F(GpuTimerTest, FramesThatTheDeviceHasNotReachedGoUnmeasured) {
  const RenderTarget target(kSizePx, false);
  GpuTimer timer;
  // Many more than the ring holds, and nothing waits for the device.
  for (int frame = 0; frame < 50; ++frame) {
    timer.begin();
    work(target);
    timer.end();
    timer.finish_frame();
  }
  glFinish();
  timer.finish_frame();
  EXPECT_GT(timer.last_ms(), 0.0);
}

TEST_F(GpuTimerTest, AddsUpIntervalsAndForgetsThem) {
  GpuTimer timer;
  GpuTimer outer;
  outer.begin();
  for (int n = 0; n < 3; ++n) {
    const RenderTarget target(kSizePx, false);
    timer.begin();
    work(target);
    timer.end();
    glFinish();
  }
  outer.end();
  timer.finish_frame();
  outer.finish_frame();
  glFinish();
  timer.finish_frame();  // a frame without an interval
  outer.finish_frame();
  EXPECT_GT(timer.last_ms(), 0.0);
  EXPECT_LE(timer.last_ms(), outer.last_ms());
  timer.finish_frame();
  EXPECT_EQ(timer.last_ms(), 0.0);
}

}  // namespace
}  // namespace prairie
