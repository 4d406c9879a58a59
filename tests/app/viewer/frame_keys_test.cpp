// Keys of the viewer that change how frames are drawn.
#include "app/viewer/frame_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace prairie {
namespace {

FrameOptions after(std::initializer_list<int> keys) {
  FrameOptions options;
  options.quality = Quality::kMedium;
  for (const int key : keys) apply_frame_key(key, options);
  return options;
}

TEST(FrameKeys, QualityGoesUpAndDownAndStaysInRange) {
  EXPECT_EQ(after({}).quality, Quality::kMedium);
  EXPECT_EQ(after({GLFW_KEY_EQUAL}).quality, Quality::kHigh);
  EXPECT_EQ(after({GLFW_KEY_KP_ADD, GLFW_KEY_EQUAL}).quality, Quality::kHigh);
  EXPECT_EQ(after({GLFW_KEY_MINUS}).quality, Quality::kLow);
  EXPECT_EQ(after({GLFW_KEY_KP_SUBTRACT, GLFW_KEY_MINUS, GLFW_KEY_EQUAL}).quality, Quality::kMedium);
  EXPECT_STREQ(quality_name(Quality::kLow), "low");
  EXPECT_STREQ(quality_name(Quality::kMedium), "medium");
  EXPECT_STREQ(quality_name(Quality::kHigh), "high");
}

TEST(FrameKeys, TiersComeInTurn) {
  EXPECT_EQ(after({GLFW_KEY_T}).tier, Tier::kSpline);
  EXPECT_EQ(after({GLFW_KEY_T, GLFW_KEY_T, GLFW_KEY_T, GLFW_KEY_T}).tier, Tier::kFlat);
  EXPECT_EQ(after({GLFW_KEY_T, GLFW_KEY_T, GLFW_KEY_T, GLFW_KEY_T, GLFW_KEY_T}).tier, Tier::kAuto);
}

TEST(FrameKeys, FieldOverlaysComeInTurn) {
  EXPECT_EQ(after({}).field_overlay, FieldOverlay::kNone);
  EXPECT_EQ(after({GLFW_KEY_O}).field_overlay, FieldOverlay::kWind);
  EXPECT_EQ(after({GLFW_KEY_O, GLFW_KEY_O}).field_overlay, FieldOverlay::kTilt);
  EXPECT_EQ(after({GLFW_KEY_O, GLFW_KEY_O, GLFW_KEY_O}).field_overlay, FieldOverlay::kRecovery);
  EXPECT_EQ(after({GLFW_KEY_O, GLFW_KEY_O, GLFW_KEY_O, GLFW_KEY_O}).field_overlay, FieldOverlay::kNone);
}

TEST(FrameKeys, TintAndSmoothEdgesToggle) {
  EXPECT_TRUE(after({GLFW_KEY_G}).tier_tint);
  EXPECT_FALSE(after({GLFW_KEY_G, GLFW_KEY_G}).tier_tint);
  EXPECT_TRUE(after({GLFW_KEY_M}).msaa);
  EXPECT_FALSE(after({GLFW_KEY_M, GLFW_KEY_M}).msaa);
  EXPECT_FALSE(after({GLFW_KEY_W}).tier_tint);
}

}  // namespace
}  // namespace prairie
