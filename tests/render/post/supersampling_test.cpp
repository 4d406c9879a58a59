#include "render/post/supersampling.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace prairie {
namespace {

TEST(SupersamplingTest, ShiftsStayWithinThePixelAndAboutItsMiddle) {
  constexpr glm::ivec2 kSizePx{640, 360};
  for (const int samples : {1, 2, 4, 7, 16, 64}) {
    glm::dvec2 sum(0.0);
    std::set<std::pair<float, float>> places;
    for (int sample = 0; sample < samples; ++sample) {
      const glm::vec2 shift = sample_shift(sample, samples, kSizePx);
      const glm::dvec2 in_pixels = glm::dvec2(shift) * glm::dvec2(kSizePx) / 2.0;
      EXPECT_LE(std::abs(in_pixels.x), 0.5);
      EXPECT_LE(std::abs(in_pixels.y), 0.5);
      sum += in_pixels;
      places.insert({shift.x, shift.y});
    }
    EXPECT_NEAR(sum.x / samples, 0.0, 1e-6) << samples;
    // The radical inverse is centred for powers of two.
    EXPECT_NEAR(sum.y / samples, 0.0, samples == 7 ? 0.1 : 1e-6) << samples;
    EXPECT_EQ(places.size(), static_cast<std::size_t>(samples));
  }
}

}  // namespace
}  // namespace prairie
