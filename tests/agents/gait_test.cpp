#include "agents/gait.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "agents/gait_of_bvh.h"

namespace prairie {
namespace {

TEST(Gait, CurvesPassThroughTheirKeyFramesSmoothly) {
  const Gait& gait = recorded_gait();
  for (std::size_t n = 0; n < kGaitCurveCount; ++n) {
    const auto curve = static_cast<GaitCurve>(n);
    for (std::size_t key = 0; key < kGaitKeyCount; ++key) {
      const double phase = static_cast<double>(key) / static_cast<double>(kGaitKeyCount), step = 1e-6;
      EXPECT_NEAR(at_phase(gait, curve, phase), gait.keys[n][key], 1e-12);
      EXPECT_NEAR(at_phase(gait, curve, phase + 3.0), gait.keys[n][key], 1e-9);
      const double before = (at_phase(gait, curve, phase) - at_phase(gait, curve, phase - step)) / step;
      const double after = (at_phase(gait, curve, phase + step) - at_phase(gait, curve, phase)) / step;
      EXPECT_NEAR(before, after, 1e-3);
    }
  }
}

TEST(Gait, StridesFollowTheSpeed) {
  const Gait& gait = recorded_gait();
  EXPECT_NEAR(stride_period_s(gait, 1.18, 1.0), 1.10, 0.05 * 1.10);
  double last_m = 0.0, last_stance = 1.0, last_amplitude = -1.0;
  for (double speed = 0.1; speed <= 2.0; speed += 0.1) {
    const double stride_m = speed * stride_period_s(gait, speed, 1.0);
    EXPECT_GT(stride_m, last_m);
    EXPECT_LT(stance_share(gait, speed, 1.0), last_stance);
    EXPECT_GT(gait_amplitude(gait, speed, 1.0), last_amplitude);
    last_m = stride_m;
    last_stance = stance_share(gait, speed, 1.0);
    last_amplitude = gait_amplitude(gait, speed, 1.0);
  }
  EXPECT_EQ(gait_amplitude(gait, 0.0, 1.0), 0.0);
  EXPECT_NEAR(gait_amplitude(gait, gait.speed_m_per_s, 1.0), 1.0, 1e-12);
  EXPECT_LT(stride_period_s(gait, 2.0, 1.0), 0.9);
}

TEST(Gait, SmallWalkersTakeShorterAndQuickerSteps) {
  const Gait& gait = recorded_gait();
  EXPECT_LT(stride_period_s(gait, 1.0, 0.7), stride_period_s(gait, 1.0, 1.0));
}

/// The recordings, where PRAIRIE_DATA names the folder that holds them.
class RecordedWalks : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("PRAIRIE_DATA");
    if (folder == nullptr) GTEST_SKIP() << "PRAIRIE_DATA is not set to the folder of recorded walks";
    folder_ = std::filesystem::path(folder) / "mocap_walk";
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << "PRAIRIE_DATA holds no mocap_walk";
  }
  std::filesystem::path folder_;
};

TEST_F(RecordedWalks, TheGaitThatComesAlongIsMadeFromItsRecording) {
  const Gait made = gait_of(read_bvh(folder_ / "02_01.bvh", "gait"), 0.0531);
  const Gait& gait = recorded_gait();
  EXPECT_NEAR(made.speed_m_per_s, gait.speed_m_per_s, 1e-5);
  EXPECT_NEAR(made.period_s, gait.period_s, 1e-5);
  EXPECT_NEAR(made.stance, gait.stance, 1e-5);
  EXPECT_NEAR(made.lead, gait.lead, 1e-5);
  EXPECT_NEAR(made.half_width, gait.half_width, 1e-5);
  for (std::size_t n = 0; n < kGaitCurveCount; ++n) {
    for (std::size_t key = 0; key < kGaitKeyCount; ++key)
      EXPECT_NEAR(made.keys[n][key], gait.keys[n][key], 2e-5);
  }
}

TEST_F(RecordedWalks, AgreeWithWhatIsKnownOfThem) {
  const Gait plain = gait_of(read_bvh(folder_ / "02_01.bvh", "gait"), 0.0531);
  EXPECT_NEAR(plain.period_s, 1.10, 0.02);
  EXPECT_NEAR(plain.speed_m_per_s, 1.18, 0.02);
  const Gait other = gait_of(read_bvh(folder_ / "walk01.bvh", "gait"));
  EXPECT_NEAR(other.period_s, 1.08, 0.02);
  EXPECT_NEAR(other.speed_m_per_s, 1.32, 0.1);
}

}  // namespace
}  // namespace prairie
