// shaders/kernels/exponential.glsl against the standard library's.
#include <gtest/gtest.h>

#include <cmath>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

TEST(ExponentialTest, IsAsCloseAsItSays) {
  double worst = 0.0;
  for (float x = 0.0f; x < 86.0f; x += 0.00037f) {
    const double expected = std::exp(-static_cast<double>(x));
    worst = std::max(worst, std::abs(static_cast<double>(Kernels{}.falling_exponential(x)) / expected - 1.0));
  }
  EXPECT_LT(worst, 3e-7);
}

TEST(ExponentialTest, EndsAreExact) {
  EXPECT_EQ(Kernels{}.falling_exponential(0.0f), 1.0f);
  EXPECT_EQ(Kernels{}.falling_exponential(-1.0f), 1.0f);
  EXPECT_EQ(Kernels{}.falling_exponential(1e9f), 0.0f);
}

TEST(ExponentialTest, Falls) {
  float previous = 1.0f;
  for (float x = 0.001f; x < 90.0f; x += 0.001f) {
    const float value = Kernels{}.falling_exponential(x);
    ASSERT_LE(value, previous) << x;
    previous = value;
  }
}

}  // namespace
}  // namespace prairie
