// What a person chooses of how frames are drawn.
#include "app/viewer/frame_choices.h"

#include <gtest/gtest.h>

namespace prairie {
namespace {

TEST(FrameChoices, QualityStaysInRange) {
  EXPECT_EQ(stepped(Quality::kLow, +1), Quality::kMedium);
  EXPECT_EQ(stepped(Quality::kHigh, +1), Quality::kHigh);
  EXPECT_EQ(stepped(Quality::kHigh, -1), Quality::kMedium);
  EXPECT_EQ(stepped(Quality::kLow, -1), Quality::kLow);
  EXPECT_STREQ(quality_name(Quality::kLow), "low");
  EXPECT_STREQ(quality_name(Quality::kMedium), "medium");
  EXPECT_STREQ(quality_name(Quality::kHigh), "high");
}

TEST(FrameChoices, TiersComeInTurn) {
  Tier tier = Tier::kAuto;
  for (const Tier next : {Tier::kSpline, Tier::kHermite, Tier::kStrip, Tier::kFlat, Tier::kAuto})
    EXPECT_EQ(tier = next_tier(tier), next);
}

TEST(FrameChoices, FieldOverlaysComeInTurn) {
  FieldOverlay overlay = FieldOverlay::kNone;
  for (const FieldOverlay next :
       {FieldOverlay::kWind, FieldOverlay::kTilt, FieldOverlay::kRecovery, FieldOverlay::kNone})
    EXPECT_EQ(overlay = next_overlay(overlay), next);
  EXPECT_STREQ(overlay_name(FieldOverlay::kWind), "wind");
  EXPECT_STREQ(overlay_name(overlay), "none");
}

}  // namespace
}  // namespace prairie
