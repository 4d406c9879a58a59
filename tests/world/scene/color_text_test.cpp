#include "world/scene/color_text.h"

#include <gtest/gtest.h>

namespace prairie {
namespace {

TEST(ColorText, TurnsSrgbIntoLinear) {
  const auto color = linear_from_hex("#ff8000");
  ASSERT_TRUE(color);
  EXPECT_FLOAT_EQ(color->x, 1.0f);
  EXPECT_NEAR(color->y, 0.21586, 1e-5);  // ((128/255 + 0.055) / 1.055)^2.4
  EXPECT_EQ(color->z, 0.0f);
}

TEST(ColorText, RefusesOtherForms) {
  for (const char* text :
       {"", "#fff", "ff8000", "#ff800", "#ff80000", "#ff80g0", "#-10000", "#+1+2+3", "# 1 2 3"}) {
    EXPECT_FALSE(linear_from_hex(text)) << text;
  }
}

}  // namespace
}  // namespace prairie
