// GPU times: none before the device is done, sums of a frame's stages, none where a stage did nothing.
#include "render/gl/gpu_timeline.h"

#include <chrono>
#include <thread>

#include "render/gl/render_target.h"
#include "tests/render/headless_test.h"

namespace prairie {
namespace {

constexpr glm::ivec2 kSizePx{1024, 1024};

using GpuTimelineTest = HeadlessTest;

void work(const RenderTarget& target) {
  for (int n = 0; n < 8; ++n) target.begin();
}

TEST_F(GpuTimelineTest, TellsTheTimesOfAFrameLater) {
  const RenderTarget target(kSizePx, false);
  GpuTimeline timeline;
  EXPECT_TRUE(timeline.last_ms().empty());
  for (int frame = 0; frame < 4; ++frame) {
    timeline.begin();
    work(target);
    timeline.end(2);
    timeline.finish_frame();
    if (frame == 0) {
      EXPECT_TRUE(timeline.last_ms().empty()) << "read in the frame in which it was made";
    }
    glFinish();
  }
  ASSERT_EQ(timeline.last_ms().size(), 3u);
  EXPECT_EQ(timeline.last_ms()[0], 0.0);
  EXPECT_EQ(timeline.last_ms()[1], 0.0);
  EXPECT_GT(timeline.last_ms()[2], 0.0);
  EXPECT_LT(timeline.last_ms()[2], 10'000.0);
}

TEST_F(GpuTimelineTest, FramesThatTheDeviceHasNotReachedGoUnmeasured) {
  const RenderTarget target(kSizePx, false);
  GpuTimeline timeline;
  // Many more than the ring holds, and nothing waits for the device.
  for (int frame = 0; frame < 50; ++frame) {
    timeline.begin();
    work(target);
    timeline.end(0);
    timeline.finish_frame();
  }
  glFinish();
  timeline.finish_frame();
  ASSERT_EQ(timeline.last_ms().size(), 1u);
  EXPECT_GT(timeline.last_ms()[0], 0.0);
}

/// What lies between an end and the next beginning is nobody's.
TEST_F(GpuTimelineTest, AddsUpStagesAndForgetsThem) {
  const RenderTarget target(kSizePx, false);
  GpuTimeline timeline, whole;
  whole.begin();
  for (int n = 0; n < 3; ++n) {
    timeline.begin();
    work(target);
    glFinish();
    timeline.end(0);
    work(target);
    glFinish();
    timeline.end(1);
    glFinish();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  whole.end(0);
  timeline.finish_frame();
  whole.finish_frame();
  glFinish();
  timeline.finish_frame();  // a frame without a stage
  whole.finish_frame();
  ASSERT_EQ(timeline.last_ms().size(), 2u);
  const double sum_ms = timeline.last_ms()[0] + timeline.last_ms()[1];
  EXPECT_GT(sum_ms, 0.0);
  EXPECT_LT(sum_ms, whole.last_ms()[0] - 50.0);
  timeline.finish_frame();
  EXPECT_TRUE(timeline.last_ms().empty());
}

}  // namespace
}  // namespace prairie
