// The kernels of the tiers: shares, sliding feet, means of coarse meshes, packed radiance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lod/thinning.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

TEST(TiersTest, SharesGoFromNoneToAllWithoutAStep) {
  Kernels kernels;
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  float morph = 0.0f, sunk = 0.0f, hermite = 0.0f;
  for (float distance_m = 0.0f; distance_m < 140.0f; distance_m += 0.05f) {
    const float next_morph = kernels.strip_morph(lod, kernels.strip_band(lod, distance_m), 0.1f);
    const float next_sunk = kernels.sunk_share(lod, distance_m);
    const float next_hermite = kernels.hermite_share(lod, distance_m);
    for (const auto& [before, after] :
         {std::pair{morph, next_morph}, std::pair{sunk, next_sunk}, std::pair{hermite, next_hermite}}) {
      ASSERT_GE(after, before) << distance_m;
      ASSERT_LE(after - before, 0.08f) << distance_m;
    }
    morph = next_morph, sunk = next_sunk, hermite = next_hermite;
  }
  EXPECT_EQ(morph, 1.0f);
  EXPECT_EQ(sunk, 1.0f);
  EXPECT_EQ(hermite, 1.0f);
  EXPECT_EQ(kernels.strip_morph(lod, 2.0f, 0.9f), 0.0f) << "no strips for those who look down";
  EXPECT_EQ(kernels.blades_left(0.0f), 1.0f);
  EXPECT_EQ(kernels.blades_left(1.0f), 0.0f);
  EXPECT_EQ(kernels.strips_grown(0.0f), 0.0f);
  EXPECT_EQ(kernels.strips_grown(1.0f), 1.0f);
}

TEST(TiersTest, FeetSlideToTheNearestEdge) {
  Kernels kernels;
  constexpr float kTileM = 4.0f;
  for (float x = 0.05f; x < kTileM; x += 0.31f) {
    for (float y = 0.02f; y < kTileM; y += 0.27f) {
      const glm::vec2 end = kernels.slid_root({x, y}, kTileM, 1.0f);
      const float to_edge = std::min({x, kTileM - x, y, kTileM - y});
      EXPECT_NEAR(std::hypot(end.x - x, end.y - y), to_edge, 1e-5f);
      EXPECT_NEAR(std::min({end.x, kTileM - end.x, end.y, kTileM - end.y}), 0.0f, 1e-5f);
      EXPECT_EQ(kernels.slid_root({x, y}, kTileM, 0.0f), glm::vec2(x, y));
    }
  }
}

TEST(TiersTest, CoarseMeshesKeepAreaAndLight) {
  Kernels kernels;
  constexpr int kSteps = 20000;
  double area = 0.0, light = 0.0, middle = 0.0;
  for (int n = 0; n < kSteps; ++n) {
    const float t = (static_cast<float>(n) + 0.5f) / kSteps;
    const auto width = static_cast<double>(kernels.blade_profile(t)) / kSteps;
    area += width;
    light += static_cast<double>(kernels.power6(t)) / kSteps;
    middle += width * static_cast<double>(t);
  }
  middle /= area;
  for (const int segments : {1, 2, 4, 8}) {
    const float h = 1.0f / static_cast<float>(segments);
    double mesh_area = 0.0, mesh_light = 0.0, mesh_middle = 0.0;
    for (int n = 0; n < kSteps; ++n) {
      const float t = (static_cast<float>(n) + 0.5f) / kSteps;
      const float lower = h * std::floor(t / h);
      const double up = static_cast<double>((t - lower) / h);
      const auto between = [&](float low, float high) {
        return (1.0 - up) * static_cast<double>(low) + up * static_cast<double>(high);
      };
      const float upper = n * segments / kSteps == segments - 1 ? 1.0f : lower + h;
      const double width = between(kernels.mean_profile(lower, h), kernels.mean_profile(upper, h)) / kSteps;
      mesh_area += width;
      mesh_light += between(kernels.mean_power6(lower, h), kernels.mean_power6(upper, h)) / kSteps;
      mesh_middle += width * between(kernels.mean_place(lower, h), kernels.mean_place(upper, h));
    }
    mesh_middle /= mesh_area;
    std::printf("%d segments: area %+.1f %%, light %+.3f of 1, colour from %+.3f of the length\n", segments,
                100.0 * (mesh_area / area - 1.0), mesh_light - light, mesh_middle - middle);
    EXPECT_NEAR(mesh_area / area, 1.0, 0.03) << segments;
    EXPECT_NEAR(mesh_light, light, 0.02) << segments;
    EXPECT_NEAR(mesh_middle, middle, 0.03) << segments;
  }
}

/// A mesh has the shape of the next coarser one before that takes its place, and its own while it is much
/// finer.
TEST(TiersTest, MeshesTakeTheShapeOfTheNext) {
  Kernels kernels;
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  for (const int segments : {8, 4, 2}) {
    const float least = kernels.least_pixels(segments);
    EXPECT_GT(least, 1.4f * kernels.least_pixels(segments / 2)) << "one blend is over before the next begins";
    EXPECT_EQ(kernels.coarser_share(lod, segments, least), 1.0f);
    EXPECT_EQ(kernels.coarser_share(lod, segments, 1.4f * least), 0.0f);
    const float h = 1.0f / static_cast<float>(segments);
    for (int n = 0; n <= segments; n += 2) {
      const float t = static_cast<float>(n) * h;
      EXPECT_EQ(kernels.blended_profile(t, h, 1.0f), kernels.mean_profile(t, 2.0f * h));
      EXPECT_EQ(kernels.blended_power6(t, h, 1.0f), kernels.mean_power6(t, 2.0f * h));
      EXPECT_EQ(kernels.blended_place(t, h, 1.0f), kernels.mean_place(t, 2.0f * h));
    }
  }
  EXPECT_EQ(kernels.coarser_share(lod, 1, 1.0f), 0.0f) << "nothing is coarser";
}

/// A quarter circle seen from the side: chords are sin(x)/x of the arc.
TEST(TiersTest, MeshesAreWiderByWhatChordsAreShort) {
  Kernels kernels;
  const auto point = [](double t) {
    const double angle = 1.5707963267948966 * t;
    return glm::vec3(glm::dvec3(std::sin(angle), 0.0, 1.0 - std::cos(angle)));
  };
  const auto seen =
      kernels.seen_areas(point(0.0), point(0.25), point(0.5), point(0.75), point(1.0), {0.0f, 1.0f, 0.0f});
  const auto chords = [](double pieces) {
    return std::sin(0.7853981633974483 / pieces) / (0.7853981633974483 / pieces);
  };
  EXPECT_NEAR(kernels.wider_for_chords(seen, 1, 0.0f), 1.0 / chords(1.0), 2e-3);
  EXPECT_NEAR(kernels.wider_for_chords(seen, 2, 0.0f), 1.0 / chords(2.0), 2e-3);
  EXPECT_NEAR(kernels.wider_for_chords(seen, 4, 0.0f), 1.0 / chords(4.0), 2e-3);
  EXPECT_NEAR(kernels.wider_for_chords(seen, 4, 1.0f), 1.0 / chords(2.0), 2e-3)
      << "blended into two segments";
}

TEST(TiersTest, RadianceSurvivesPacking) {
  Kernels kernels;
  for (float value = 1e-4f; value < 1000.0f; value *= 1.07f) {
    const glm::vec3 radiance(value, 0.3f * value, 2.0f * value);
    const glm::vec3 packed = kernels.unpack_radiance(kernels.pack_radiance(radiance));
    EXPECT_NEAR(packed.x / radiance.x, 1.0f, 1.0f / 128.0f + 1e-5f);
    EXPECT_NEAR(packed.y / std::max(radiance.y, 6.2e-5f), 1.0f, 1.0f / 128.0f + 1e-5f);
    EXPECT_NEAR(packed.z / radiance.z, 1.0f, 1.0f / 64.0f + 1e-5f);
  }
}

TEST(TiersTest, DenseSwardsKeepNoMoreBladesThanOthers) {
  Kernels kernels;
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  EXPECT_EQ(kernels.crowded_share(lod, 100.0f), 1.0f);
  EXPECT_FLOAT_EQ(10000.0f * kernels.crowded_share(lod, 10000.0f),
                  2000.0f * kernels.crowded_share(lod, 2000.0f));
  EXPECT_EQ(kernels.crowded_share(tier_coefficients(Tier::kSpline, Quality::kLow, 1.0, Camera{}), 1e5f),
            1.0f);
}

}  // namespace
}  // namespace prairie
