// The kernels' own sine and cosine: absolute error below 4e-7 for |x| ≤ 2π, as
// shaders/kernels/trigonometry.glsl says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

TEST(TrigonometryTest, SineAndCosineAreWithinTheStatedError) {
  double sine_error = 0.0, cosine_error = 0.0;
  for (int n = -3141592; n <= 3141592; ++n) {
    const float x = static_cast<float>(n) * 2e-6f;
    const double exact = static_cast<double>(x);
    sine_error = std::max(sine_error, std::abs(static_cast<double>(Kernels{}.sine(x)) - std::sin(exact)));
    cosine_error =
        std::max(cosine_error, std::abs(static_cast<double>(Kernels{}.cosine(x)) - std::cos(exact)));
  }
  std::printf("sine within %.2g, cosine within %.2g for |x| <= 2 pi\n", sine_error, cosine_error);
  EXPECT_LE(sine_error, 4e-7);
  EXPECT_LE(cosine_error, 4e-7);
}

TEST(TrigonometryTest, StaysWithinOneButForRounding) {
  for (int n = -100000; n <= 100000; ++n) {
    const float x = static_cast<float>(n) * 1e-4f;
    ASSERT_LE(std::abs(Kernels{}.sine(x)), 1.000001f) << x;
  }
}

}  // namespace
}  // namespace prairie
