#include "app/viewer/screenshot_name.h"

#include <gtest/gtest.h>

#include "tests/maps/test_images.h"

namespace prairie {
namespace {

TEST(ScreenshotName, TakesTheFirstFreeNumber) {
  const TemporaryFolder folder;
  EXPECT_EQ(free_screenshot_name(folder.path()), folder / "prairie-0001.png");
  testing::write_text(folder / "prairie-0001.png", "");
  testing::write_text(folder / "prairie-0003.png", "");
  EXPECT_EQ(free_screenshot_name(folder.path()), folder / "prairie-0002.png");
}

}  // namespace
}  // namespace prairie
