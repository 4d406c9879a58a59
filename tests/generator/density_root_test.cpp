// The root that inverts a linear density, against the same in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

/// Where ∫₀ᵗ (a + (b − a)s) ds = u (a + b)/2, by bisection: no formula of its own to be wrong in.
long double root_by_bisection(long double u, long double a, long double b) {
  long double low = 0.0L, high = 1.0L;
  for (int step = 0; step < 70; ++step) {
    const long double t = 0.5L * (low + high);
    const long double mass = a * t + 0.5L * (b - a) * t * t;
    (mass < 0.5L * u * (a + b) ? low : high) = t;
  }
  return 0.5L * (low + high);
}

double worst_error(float a, float b) {
  double worst = 0.0;
  for (int n = 0; n < 1000; ++n) {
    const float u = static_cast<float>(n) / 1000.0f;
    const long double exact = root_by_bisection(static_cast<long double>(u), static_cast<long double>(a),
                                                static_cast<long double>(b));
    const double error = std::abs(
        static_cast<double>(static_cast<long double>(Kernels{}.linear_density_root(u, a, b)) - exact));
    worst = std::max(worst, error);
  }
  return worst;
}

/// Six roundings of at most 6e-8 each: 4e-7 of a patch, 0.8 µm in a cell of 2 m.
constexpr double kTolerance = 4e-7;

TEST(DensityRootTest, InvertsLinearDensities) {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> density(0.0f, 3000.0f);
  double worst = 0.0;
  for (int n = 0; n < 300; ++n) worst = std::max(worst, worst_error(density(random), density(random)));
  std::printf("random ends: within %.2g of a patch\n", worst);
  EXPECT_LE(worst, kTolerance);
}

TEST(DensityRootTest, HoldsWhereTheEndsAreNearlyEqual) {
  for (const float difference : {0.0f, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f}) {
    EXPECT_LE(worst_error(1000.0f, 1000.0f * (1.0f + difference)), kTolerance) << difference;
    EXPECT_LE(worst_error(1000.0f * (1.0f + difference), 1000.0f), kTolerance) << difference;
  }
}

TEST(DensityRootTest, HoldsWhereOneEndIsBare) {
  EXPECT_LE(worst_error(0.0f, 1000.0f), kTolerance);
  EXPECT_LE(worst_error(1000.0f, 0.0f), 1e-5)
      << "near the bare end 1 − t = √(1 − u), which float resolves less well";
  EXPECT_LE(worst_error(1e-6f, 1e5f), kTolerance);
}

TEST(DensityRootTest, BareGroundDividesByNothing) {
  for (int n = 0; n < 100; ++n) {
    const float u = static_cast<float>(n) / 100.0f;
    EXPECT_EQ(Kernels{}.linear_density_root(u, 0.0f, 0.0f), u);
  }
}

TEST(DensityRootTest, NeverLeavesThePatch) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> exponent(-20.0f, 5.0f);
  for (int n = 0; n < 100000; ++n) {
    const float a = std::pow(10.0f, exponent(random));
    const float b = std::pow(10.0f, exponent(random));
    for (const float u : {0.0f, 1e-7f, 0.5f, 0.9999999f, 1.0f}) {
      const float t = Kernels{}.linear_density_root(u, a, b);
      ASSERT_TRUE(t >= 0.0f && t < 1.0f) << a << ' ' << b << ' ' << u;
    }
  }
}

}  // namespace
}  // namespace prairie
