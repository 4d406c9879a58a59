// B11's weight function and what follows from it, against the same formulas in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "lod/thinning.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr float kWidthM = 0.004f;

/// 1 − F before it is clamped to 1, F(z, φ) = 1 − clamp(((1 − t)(n·r) + t)/(a1 + a2 d + a3 d²), 0, 1), t = (1
/// − |n·r|)⁸, times the sinking of all blades towards the farthest distance.
double kept_as_printed(const LodCoefficients& lod, double n_dot_r, double pixel_m, double distance_m) {
  const double x = std::clamp(n_dot_r, 0.0, 1.0);
  const double t = std::pow(1.0 - x, 8.0);
  const double d = pixel_m / static_cast<double>(lod.reference_pixel);
  const double share = ((1.0 - t) * x + t) / (static_cast<double>(lod.a1) + static_cast<double>(lod.a2) * d +
                                              static_cast<double>(lod.a3) * d * d);
  const double start_m = static_cast<double>(lod.fade_start_m);
  const double sunk =
      std::clamp((distance_m - start_m) / (static_cast<double>(lod.fade_end_m) - start_m), 0.0, 1.0);
  return share * (1.0 - sunk * sunk * (3.0 - 2.0 * sunk));
}

TEST(WeightTest, KeepShareIsOneMinusF) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> cosine(-1.0, 1.0), distance(0.05, 150.0), pixel(0.3, 3.0);
  for (const Quality quality : {Quality::kLow, Quality::kMedium, Quality::kHigh}) {
    const LodCoefficients lod = tier_coefficients(Tier::kAuto, quality, 120.0, Camera{});
    for (int n = 0; n < 100000; ++n) {
      const double n_dot_r = cosine(random);
      const double distance_m = distance(random);
      const double pixel_m = pixel(random) * static_cast<double>(lod.reference_pixel) * distance_m;
      const double kept = kept_as_printed(lod, n_dot_r, pixel_m, distance_m);
      const float result = Kernels{}.keep_share(lod, static_cast<float>(n_dot_r), static_cast<float>(pixel_m),
                                                static_cast<float>(distance_m), 0.0f);
      // Float arithmetic, and the last part of the sinking, which is a small difference of numbers near one.
      ASSERT_NEAR(static_cast<double>(result), kept, 3e-6 * kept + 1e-6) << n_dot_r << ' ' << distance_m;
    }
  }
}

TEST(WeightTest, FallsWithDistanceAndEndsWhereBladesEnd) {
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  float previous = 1e30f;
  for (float distance_m = 0.1f; distance_m < 130.0f; distance_m += 0.05f) {
    const float keep = Kernels{}.keep_share(lod, 0.3f, lod.reference_pixel * distance_m, distance_m, kWidthM);
    ASSERT_LE(keep, previous) << distance_m;
    previous = keep;
  }
  EXPECT_EQ(previous, 0.0f);
  EXPECT_GE(Kernels{}.keep_share(lod, 1.0f, lod.reference_pixel * 0.5f, 0.5f, kWidthM), 1.0f)
      << "all blades near the eye";
}

TEST(WeightTest, FinerPicturesThinLater) {
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  EXPECT_GT(Kernels{}.keep_share(lod, 0.3f, 0.5f * lod.reference_pixel * 20.0f, 20.0f, kWidthM),
            Kernels{}.keep_share(lod, 0.3f, lod.reference_pixel * 20.0f, 20.0f, kWidthM));
}

TEST(WeightTest, AreaLeftIsTheIntegralOfGrowth) {
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  for (const float keep : {1e-4f, 0.01f, 0.3f, 0.8f, 0.999f, 1.0f, 1.001f, 1.2f, 1.4f, 1.43f, 2.0f, 50.0f}) {
    double sum = 0.0;
    constexpr int kRanks = 200000;
    for (int n = 0; n < kRanks; ++n) {
      sum += static_cast<double>(Kernels{}.growth_of(lod, keep, (static_cast<float>(n) + 0.5f) / kRanks));
    }
    EXPECT_NEAR(static_cast<double>(Kernels{}.area_left(lod, keep)), sum / kRanks, 2e-5) << keep;
  }
}

TEST(WeightTest, KeepLeavingIsTheInverseOfAreaLeft) {
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  for (float area = 0.001f; area <= 1.0f; area += 0.001f) {
    EXPECT_NEAR(Kernels{}.area_left(lod, Kernels{}.keep_leaving(lod, area)), area, 2e-5f) << area;
  }
}

/// Blades that stay stand for those left out, and none is wider than its limit of pixels.
TEST(WeightTest, WideningKeepsTheCover) {
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  for (float distance_m = 0.5f; distance_m < 60.0f; distance_m *= 1.1f) {
    const float pixel_m = lod.reference_pixel * distance_m;
    const float keep = Kernels{}.keep_share(lod, 0.5f, pixel_m, distance_m, kWidthM);
    const float wide_m = Kernels{}.widened_m(lod, keep, kWidthM, pixel_m);
    EXPECT_GE(wide_m, kWidthM);
    EXPECT_NEAR(wide_m * Kernels{}.area_left(lod, keep), kWidthM, 1e-5f * kWidthM) << distance_m;
    EXPECT_LE(wide_m, std::max(kWidthM, lod.widest_pixels * pixel_m) * 1.00001f);
  }
}

/// Nothing pops: while the eye walks in steps of 5 cm, no blade grows or sinks by more than a few hundredths
/// a step from 3 m on, wherever it ranks. (Nearer than that, all blades stand anyway.)
TEST(WeightTest, BladesGrowInRatherThanPop) {
  for (const Quality quality : {Quality::kLow, Quality::kMedium, Quality::kHigh}) {
    const LodCoefficients lod = tier_coefficients(Tier::kAuto, quality, 120.0, Camera{});
    double fastest = 0.0;
    for (int rank = 0; rank <= 1000; ++rank) {
      float previous = -1.0f;
      for (int step = 0; step < 2600; ++step) {
        const double along_m = 0.05 * step;
        const double distance_m = std::hypot(along_m, 1.7);
        const float keep = Kernels{}.keep_share(lod, static_cast<float>(1.7 / distance_m),
                                                lod.reference_pixel * static_cast<float>(distance_m),
                                                static_cast<float>(distance_m), kWidthM);
        const float growth = Kernels{}.growth_of(lod, keep, 0.001f * (static_cast<float>(rank) + 0.5f));
        if (previous >= 0.0f) fastest = std::max(fastest, static_cast<double>(std::abs(growth - previous)));
        previous = growth;
      }
    }
    std::printf("fastest growth: %.3f of a blade per 5 cm of walking\n", fastest);
    EXPECT_LE(fastest, 0.15);
  }
}

TEST(WeightTest, AllBladesMeansAll) {
  const LodCoefficients lod = tier_coefficients(Tier::kSpline, Quality::kMedium, 120.0, Camera{});
  for (const float distance_m : {0.1f, 10.0f, 1000.0f, 100000.0f}) {
    for (const float n_dot_r : {0.0f, 0.01f, 0.26f, 1.0f}) {
      const float keep =
          Kernels{}.keep_share(lod, n_dot_r, lod.reference_pixel * distance_m, distance_m, kWidthM);
      EXPECT_EQ(Kernels{}.growth_of(lod, keep, 1.0f), 1.0f);
      EXPECT_EQ(Kernels{}.widened_m(lod, keep, 0.004f, 1.0f), 0.004f);
    }
  }
}

}  // namespace
}  // namespace prairie
