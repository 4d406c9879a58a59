// The windows around the eye that hold what has come over the grass, and how virtual blades stiffen by them.
#include "animation/condition_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

#include "animation/sway.h"
#include "moving_meadow.h"

namespace prairie {
namespace {

using testing::moving_sway;

Condition frost(glm::dvec2 centre_m, double radius_m) {
  return {.centre_m = centre_m,
          .radius_m = radius_m,
          .edge_m = 0.4 * radius_m,
          .color_factor = {1.35f, 1.4f, 1.6f},
          .stiffness_factor = 4.0};
}

bool is_neutral(const ConditionWindow& window) {
  return std::all_of(window.image().begin(), window.image().end(),
                     [](glm::vec4 texel) { return texel == glm::vec4(1.0f); });
}

TEST(ConditionWindow, HoldsWhatNodesHaveNearTheEye) {
  const std::vector<Condition> conditions{frost({3.0, 2.0}, 12.0)};
  ConditionWindow window({1.3, -2.2});
  EXPECT_TRUE(window.show(conditions, {1.3, -2.2}, 0.0));
  const std::vector<PresentCondition> present = present_conditions(conditions, 0.0);
  for (double x = -20.0; x < 22.0; x += 0.73) {
    const GrassCondition found = window.at({x, 0.4}), wanted = grass_condition(present, {x, 0.4});
    // A texel of a metre against an edge of 4.8 m.
    EXPECT_NEAR(found.color_factor.z, wanted.color_factor.z, 0.025f) << x;
    EXPECT_NEAR(found.stiffness_factor, wanted.stiffness_factor, 0.15f) << x;
  }
  EXPECT_EQ(window.at({3.0, 2.0}).color_factor, glm::vec3(1.35f, 1.4f, 1.6f));
  EXPECT_EQ(window.at({-20.0, 2.0}), GrassCondition{}) << "exactly untouched";
}

TEST(ConditionWindow, HasNoSeamBetweenItsWindows) {
  ConditionWindow window({3.2, -7.7});
  window.show(std::vector<Condition>{frost({30.0, 5.0}, 25.0), frost({-100.0, -20.0}, 60.0)}, {3.2, -7.7},
              0.0);
  float most = 0.0f;
  for (std::size_t level = 0; level + 1 < kWindowLevels; ++level) {
    const double border_m = fade_end_m(window_half_m(level));
    for (int n = 0; n < 200; ++n) {
      const double along_m = (n / 100.0 - 1.0) * border_m;
      for (const double side : {-1.0, 1.0}) {
        const GrassCondition inside =
            window.at(window.centre_m() + glm::dvec2(side * (border_m - 1e-6), along_m));
        const GrassCondition outside =
            window.at(window.centre_m() + glm::dvec2(side * (border_m + 1e-6), along_m));
        most = std::max(most, glm::length(inside.color_factor - outside.color_factor));
      }
    }
  }
  // The coarser window's own lattice bends within a texel of the finer. The change of colour is 0.8 in all.
  EXPECT_LT(most, 0.02f);
}

TEST(ConditionWindow, EverywhereTheSameWhereOneCoversAll) {
  ConditionWindow window({0.0, 0.0});
  window.show(std::vector<Condition>{frost({0.0, 0.0}, 1e5)}, {0.0, 0.0}, 0.0);
  // The last window's mean is a sum of 4096 floats.
  for (const glm::vec4& texel : window.image())
    ASSERT_LT(glm::length(texel - glm::vec4(1.35f, 1.4f, 1.6f, 4.0f)), 3e-4f);
  EXPECT_NEAR(window.at({7000.0, 50.0}).color_factor.z, 1.6f, 1e-4f) << "beyond the last window";
}

TEST(ConditionWindow, IsMadeAnewOnlyWhenSomethingChanges) {
  ConditionWindow window({0.0, 0.0});
  Condition spell = frost({0.0, 0.0}, 10.0);
  spell.start_s = 5.0;
  spell.duration_s = 10.0;
  spell.fade_s = 2.0;
  const std::vector<Condition> conditions{spell, frost({4000.0, 0.0}, 10.0)};
  const std::uint64_t first = window.revision();
  for (double time_s = 0.0; time_s < 5.0; time_s += 0.5) {
    EXPECT_FALSE(window.show(conditions, {2.0 * time_s, 0.0}, time_s))
        << "neither it nor one far away covers anything";
  }
  EXPECT_EQ(window.revision(), first);
  EXPECT_TRUE(is_neutral(window));
  EXPECT_TRUE(window.show(conditions, {10.0, 0.0}, 6.0)) << "it comes";
  EXPECT_TRUE(window.show(conditions, {10.0, 0.0}, 8.0));
  const std::uint64_t there = window.revision();
  EXPECT_FALSE(window.show(conditions, {10.0, 0.0}, 9.0)) << "it stays";
  EXPECT_EQ(window.revision(), there);
  EXPECT_FALSE(window.show(conditions, {10.1, 0.0}, 9.5)) << "no texel moves";
  EXPECT_GT(window.revision(), there) << "but windows fade by the eye's place";
  EXPECT_TRUE(window.show(conditions, {12.1, 0.0}, 10.0));
  EXPECT_TRUE(window.show(conditions, {12.1, 0.0}, 20.0)) << "it has gone";
  EXPECT_TRUE(is_neutral(window));
  const std::uint64_t gone = window.revision();
  EXPECT_FALSE(window.show(conditions, {15.1, 0.0}, 21.0));
  EXPECT_EQ(window.revision(), gone);
}

TEST(ConditionWindow, IsAFunctionOfPlaceAndTime) {
  Condition moving = frost({-20.0, 0.0}, 15.0);
  moving.velocity_m_per_s = {1.5, 0.4};
  const std::vector<Condition> conditions{moving, frost({10.0, 10.0}, 9.0)};
  ConditionWindow walked({0.0, 0.0});
  for (int step = 0; step <= 100; ++step) walked.show(conditions, {0.13 * step, -0.07 * step}, 0.1 * step);
  ConditionWindow anew({70.0, 70.0});
  anew.show(conditions, walked.centre_m(), 10.0);
  EXPECT_EQ(std::memcmp(walked.image().data(), anew.image().data(), anew.image().size_bytes()), 0);
}

TEST(ConditionWindow, StiffensBladesAsAStifferSpecies) {
  Wind wind;
  wind.mean = MeanWind(glm::dvec2(4.0, 1.0));
  wind.noise.emplace(NoiseWindSettings{});
  ConditionWindow window({0.0, 0.0});
  Condition everywhere = frost({0.0, 0.0}, 1e5);
  window.show(std::vector<Condition>{everywhere}, {0.0, 0.0}, 0.0);
  Sway conditioned(moving_sway(), {0.0, 0.0});
  conditioned.stiffen(window);
  std::vector<SwaySpecies> stiff = moving_sway();
  for (SwaySpecies& species : stiff) species.traits.stiffness *= 4.0f;
  Sway bred(stiff, {0.0, 0.0}), plain(moving_sway(), {0.0, 0.0});
  float most = 0.0f, tip = 0.0f, plain_tip = 0.0f;
  for (int step = 1; step <= 240; ++step) {
    for (Sway* sway : {&conditioned, &bred, &plain}) sway->step(wind, step / 60.0, 1.0f / 60.0f);
    for (std::size_t n = 0; n < bred.image().size(); n += 37)
      most = std::max(most, glm::length(conditioned.image()[n] - bred.image()[n]));
    tip = std::max(tip, glm::length(conditioned.mean_tip({1.0, 2.0})));
    plain_tip = std::max(plain_tip, glm::length(plain.mean_tip({1.0, 2.0})));
  }
  std::printf("off by %.1e at most; tips move by %.3f of their length, unfrozen ones by %.3f\n",
              static_cast<double>(most), static_cast<double>(tip), static_cast<double>(plain_tip));
  EXPECT_LT(most, 1e-5f);
  EXPECT_LT(tip, 0.4f * plain_tip);
  EXPECT_GT(tip, 0.1f * plain_tip);
}

}  // namespace
}  // namespace prairie
