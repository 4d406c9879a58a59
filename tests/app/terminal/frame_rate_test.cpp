#include "app/terminal/frame_rate.h"

#include <gtest/gtest.h>

#include "app/terminal/usage_error.h"

namespace prairie {
namespace {

TEST(FrameRateOption, IsExact) {
  const auto rate = [](const char* text) { return frame_rate_option("--fps", text); };
  EXPECT_EQ(rate("30"), (FrameRate{30, 1}));
  EXPECT_EQ(rate("30000/1001"), (FrameRate{30000, 1001}));
  EXPECT_EQ(rate("29.97"), (FrameRate{30000, 1001}));
  EXPECT_EQ(rate("23.976"), (FrameRate{24000, 1001}));
  EXPECT_EQ(rate("59.94"), (FrameRate{60000, 1001}));
  EXPECT_EQ(rate("12.5"), (FrameRate{25, 2}));
  EXPECT_EQ(rate("0.5"), (FrameRate{1, 2}));
  EXPECT_EQ(rate("50/2"), (FrameRate{25, 1}));
  EXPECT_EQ(rate("30000/1001").text(), "30000/1001");
  EXPECT_EQ(rate("24").text(), "24");
  EXPECT_DOUBLE_EQ(rate("30000/1001").time_s(30000), 1001.0);
}

TEST(FrameRateOption, RefusesWhatIsNone) {
  for (const char* text :
       {"", "0", "-3", "241", "30/0", "0/1", "1/2/3", "30000/", "/1001", "fast", "nan", "1000000/1"})
    EXPECT_THROW(frame_rate_option("--fps", text), UsageError) << text;
}

}  // namespace
}  // namespace prairie
