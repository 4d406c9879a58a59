// The windows of virtual blades around the eye.
#include "animation/sway.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <glm/geometric.hpp>

#include "moving_meadow.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

using testing::moving_sway;

Wind breezy() {
  Wind wind;
  wind.mean = MeanWind(glm::dvec2(3.0, 1.0));
  wind.noise.emplace(NoiseWindSettings{});
  wind.primitives.push_back(Gust{.origin_m = {-20.0, 0.0}});
  return wind;
}

float difference(const VirtualTexel& a, const VirtualTexel& b) {
  float most = 0.0f;
  for (std::size_t n = 0; n < 4; ++n) most = std::max(most, glm::length(a.segments[n] - b.segments[n]));
  return most;
}

TEST(Sway, HasNoSeamBetweenItsWindows) {
  Sway sway(moving_sway(), {3.2, -7.7});
  const Wind wind = breezy();
  for (int step = 0; step < 120; ++step) sway.step(wind, step / 60.0, 1.0f / 60.0f);
  const double half_m = 0.5 * layouts::kSwaySide * static_cast<double>(layouts::kSwayFinestM);
  float most = 0.0f, typical = 0.0f;
  for (const double border_m :
       {fade_end_m(half_m), fade_end_m(half_m * static_cast<double>(layouts::kSwayCoarsening))}) {
    for (int n = 0; n < 200; ++n) {
      const double along_m = (n / 100.0 - 1.0) * border_m;
      const glm::dvec2 inside = sway.centre_m() + glm::dvec2(border_m - 1e-6, along_m);
      const glm::dvec2 outside = sway.centre_m() + glm::dvec2(border_m + 1e-6, along_m);
      most = std::max(most, difference(sway.at(0, inside), sway.at(0, outside)));
      typical = std::max(typical, glm::length(glm::vec3(sway.at(0, inside).segments[0])));
    }
  }
  // The coarser window's own lattice bends within a texel of the finer.
  EXPECT_LT(most, 0.02f * typical);
}

TEST(Sway, StaysWhereItIsWhenTheEyeMoves) {
  const Wind wind = breezy();
  Sway sway(moving_sway(), {0.0, 0.0});
  for (int step = 0; step < 120; ++step) sway.step(wind, step / 60.0, 1.0f / 60.0f);
  const VirtualTexel before = sway.at(1, {5.3, 4.1});
  sway.follow({6.4, -3.9});
  EXPECT_EQ(difference(sway.at(1, {5.3, 4.1}), before), 0.0f) << "before time goes on";
  sway.step(wind, 2.0, 1.0f / 60.0f);
  Sway still(moving_sway(), {0.0, 0.0});
  for (int step = 0; step <= 120; ++step) still.step(wind, step / 60.0, 1.0f / 60.0f);
  EXPECT_LT(difference(sway.at(1, {5.3, 4.1}), still.at(1, {5.3, 4.1})), 1e-6f);
  EXPECT_GT(difference(before, VirtualTexel{}), 0.0f);
}

TEST(Sway, EndsInItsMean) {
  Sway sway(moving_sway(), {0.0, 0.0});
  const Wind wind = breezy();
  for (int step = 0; step < 60; ++step) sway.step(wind, step / 60.0, 1.0f / 60.0f);
  const glm::vec3 north = sway.mean_tip({10.0, 5000.0}), west = sway.mean_tip({-7000.0, -300.0});
  EXPECT_NEAR(glm::distance(north, west), 0.0f, 1e-5f);
  EXPECT_GT(north.x, 0.01f);
}

TEST(Sway, IsRestoredAndTheSameForAnyNumberOfThreads) {
  const Wind wind = breezy();
  const auto run = [&](std::size_t threads, bool restored) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Sway sway(moving_sway(), {1.0, 2.0});
    for (int step = 1; step <= 60; ++step) {
      sway.step(wind, step / 60.0, 1.0f / 60.0f);
      if (!restored || step != 30) continue;
      const SwayState state = sway.state();
      const std::vector<glm::vec4> image(sway.image().begin(), sway.image().end());
      sway = Sway(moving_sway(), {50.0, 50.0});
      sway.restore(state, wind, step / 60.0);
      EXPECT_EQ(std::memcmp(image.data(), sway.image().data(), sway.image().size_bytes()), 0);
    }
    return std::vector<glm::vec4>(sway.image().begin(), sway.image().end());
  };
  const std::vector<glm::vec4> one = run(1, false);
  EXPECT_TRUE(one == run(4, false));
  EXPECT_TRUE(one == run(2, true));
}

}  // namespace
}  // namespace prairie
