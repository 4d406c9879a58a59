// Conditions of grass in scene files, in a world that steps, and in its saved state.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

#include "tests/world/scene_texts.h"
#include "world/motion.h"
#include "world/scene/scene_hash.h"
#include "world/world.h"

namespace prairie {
namespace {

using testing::expect_refused;
using testing::kPlainScene;
using testing::Refusal;
using testing::refusal_of;

Scene plain_with(const std::string& more, const std::vector<std::string>& overrides = {}) {
  return parse_scene(std::string(kPlainScene) + more, "folder", overrides);
}

constexpr const char* kFrost = R"([[condition]]
centre_m = [12, 8]
velocity_m_per_s = [0.5, -0.25]
radius_m = 9
edge_m = 4
start_s = 0.5
duration_s = 60
fade_s = 3
color_factor = [1.35, 1.4, 1.6]
stiffness_factor = 4
)";

TEST(ConditionScene, ReadsEveryKey) {
  EXPECT_TRUE(plain_with("").conditions.empty());
  const Scene scene =
      plain_with(std::string(kFrost) + "[[condition]]\ncolor_factor = \"#ff8000\"\nradius_m = 2\n");
  ASSERT_EQ(scene.conditions.size(), 2u);
  const Condition& frost = scene.conditions[0];
  EXPECT_EQ(frost.centre_m, glm::dvec2(12.0, 8.0));
  EXPECT_EQ(frost.velocity_m_per_s, glm::dvec2(0.5, -0.25));
  EXPECT_EQ(frost.radius_m, 9.0);
  EXPECT_EQ(frost.edge_m, 4.0);
  EXPECT_EQ(frost.start_s, 0.5);
  EXPECT_EQ(frost.duration_s, 60.0);
  EXPECT_EQ(frost.fade_s, 3.0);
  EXPECT_EQ(frost.color_factor, glm::vec3(1.35f, 1.4f, 1.6f));
  EXPECT_EQ(frost.stiffness_factor, 4.0);
  const Condition& plain = scene.conditions[1];
  EXPECT_EQ(plain.edge_m, 2.0) << "no more than the radius";
  EXPECT_EQ(plain.color_factor.x, 1.0f);
  EXPECT_EQ(plain.color_factor.z, 0.0f);
  EXPECT_EQ(plain.stiffness_factor, 1.0);
  EXPECT_EQ(plain.start_s, 0.0);
  EXPECT_EQ(plain_with(kFrost, {"condition.0.radius_m=20"}).conditions[0].radius_m, 20.0);
  EXPECT_EQ(plain_with("", {"condition=[{ radius_m = 3 }]"}).conditions[0].radius_m, 3.0);
}

TEST(ConditionScene, HasItsLimit) {
  std::string all;
  for (std::size_t n = 0; n < kMaxConditions; ++n) all += "[[condition]]\n";
  EXPECT_EQ(plain_with(all).conditions.size(), kMaxConditions);
  EXPECT_EQ(refusal_of(kPlainScene + all + "[[condition]]\n").field, "condition");
}

class ConditionRefusal : public ::testing::TestWithParam<Refusal> {};

TEST_P(ConditionRefusal, NamesTheField) {
  expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Values, ConditionRefusal,
    ::testing::Values(
        Refusal{"[condition]", "condition", "[[condition]]"},
        Refusal{"[[conditions]]", "conditions", "did you mean 'condition'?"},
        Refusal{"[[condition]]\nradius = 3", "condition.0.radius", "did you mean 'radius_m'?"},
        Refusal{"[[condition]]\nwetness = 3", "condition.0.wetness", "unknown key 'wetness' in line 7"},
        Refusal{"[[condition]]\nradius_m = -3", "condition.0.radius_m",
                "found -3 in line 7, expected 0.01 to"},
        Refusal{"[[condition]]\nradius_m = nan", "condition.0.radius_m", "found nan in line 7"},
        Refusal{"[[condition]]\nradius_m = \"a\"", "condition.0.radius_m", "a number"},
        Refusal{"[[condition]]\nradius_m = 3\nradius_m = 4", "line 8, column 12", "redefine"},
        Refusal{"[[condition]]\nradius_m = 4\nedge_m = 5", "condition.0.edge_m",
                "found 5 in line 8, expected 0.01 to 4"},
        Refusal{"[[condition]]\nedge_m = 0", "condition.0.edge_m", "found 0 in line 7"},
        Refusal{"[[condition]]\n[[condition]]\nstart_s = inf", "condition.1.start_s", "found inf in line 8"},
        Refusal{"[[condition]]\nduration_s = -1", "condition.0.duration_s", "found -1"},
        Refusal{"[[condition]]\nfade_s = nan", "condition.0.fade_s", "found nan"},
        Refusal{"[[condition]]\ncentre_m = [0]", "condition.0.centre_m", "two numbers"},
        Refusal{"[[condition]]\ncentre_m = [0, nan]", "condition.0.centre_m", "found nan"},
        Refusal{"[[condition]]\nvelocity_m_per_s = [0, 101]", "condition.0.velocity_m_per_s", "-100 to 100"},
        Refusal{"[[condition]]\nvelocity_m_per_s = 3", "condition.0.velocity_m_per_s", "two numbers"},
        Refusal{"[[condition]]\ncolor_factor = [1, 1]", "condition.0.color_factor", "a list of 2 in line 7"},
        Refusal{"[[condition]]\ncolor_factor = [1, 1, 5]", "condition.0.color_factor", "0 to 4"},
        Refusal{"[[condition]]\ncolor_factor = [1, 1, nan]", "condition.0.color_factor", "found nan"},
        Refusal{"[[condition]]\nstiffness_factor = 0", "condition.0.stiffness_factor", "0.1 to 10"},
        Refusal{"[[condition]]\nstiffness_factor = 11", "condition.0.stiffness_factor",
                "found 11 in line 7"}));

TEST(ConditionScene, BelongsToTheScenesHash) {
  const auto hash_of = [](const std::string& more, const std::vector<std::string>& overrides = {}) {
    return scene_hash(plain_with(more, overrides), {});
  };
  const std::uint64_t hash = hash_of(kFrost);
  EXPECT_NE(hash, hash_of(""));
  for (const char* change :
       {"condition.0.centre_m=[12, 9]", "condition.0.velocity_m_per_s=[0, 0]", "condition.0.radius_m=8",
        "condition.0.edge_m=3", "condition.0.start_s=1", "condition.0.duration_s=50", "condition.0.fade_s=2",
        "condition.0.color_factor=[1.35, 1.4, 1.5]", "condition.0.stiffness_factor=3"}) {
    EXPECT_NE(hash, hash_of(kFrost, {change})) << change;
  }
}

constexpr double kStepS = 1.0 / 60.0;
constexpr const char* kWind = "[wind]\nspeed_m_per_s = 5\nheading_deg = 80\n";

World world_with(const std::string& more) {
  return World(plain_with(more, {"species.0.density=30"}), {});
}

TEST(ConditionWorld, AsksForNothingWhereThereIsNone) {
  World world = world_with(kWind);
  world.motion().watch({9.0, 6.0});
  world.step(kStepS);
  EXPECT_EQ(world.motion().conditions(), nullptr);
  World frozen = world_with(kFrost);
  frozen.step(kStepS);
  EXPECT_EQ(frozen.motion().conditions(), nullptr) << "nobody watches";
}

TEST(ConditionWorld, ComesInCalmAir) {
  World world = world_with(kFrost);
  world.motion().watch({9.0, 6.0});
  EXPECT_FALSE(world.motion().is_still());
  EXPECT_EQ(world.motion().conditions()->at({12.0, 8.0}), GrassCondition{}) << "before it begins";
  for (int n = 0; n < 300; ++n) world.step(kStepS);
  EXPECT_FALSE(world.motion().sway());
  const GrassCondition frozen = world.motion().conditions()->at({14.2, 6.9});
  EXPECT_NEAR(frozen.color_factor.z, 1.6f, 1e-5f);
  EXPECT_NEAR(frozen.stiffness_factor, 4.0f, 1e-5f);
}

TEST(ConditionWorld, FrostHoldsTheSwardStill) {
  const auto farthest_tip = [](const std::string& more) {
    World world = world_with(kWind + more);
    world.watch_anew({12.0, 8.0});
    float most = 0.0f;
    for (int n = 0; n < 120; ++n) {
      world.step(kStepS);
      most = std::max(most, glm::length(world.motion().sway()->mean_tip({12.0, 8.0})));
    }
    return most;
  };
  const float plain = farthest_tip(""),
              frozen = farthest_tip("[[condition]]\ncentre_m = [12, 8]\nstiffness_factor = 4\n");
  EXPECT_LT(frozen, 0.4f * plain);
  EXPECT_GT(frozen, 0.1f * plain);
}

TEST(ConditionWorld, MayBeSpawned) {
  World world = world_with(kWind);
  Motion& motion = world.motion();
  motion.watch({9.0, 6.0});
  for (int n = 0; n < 30; ++n) world.step(kStepS);
  motion.spawn(
      Condition{.centre_m = {9.0, 6.0}, .color_factor = {0.5f, 1.0f, 1.0f}, .stiffness_factor = 8.0});
  ASSERT_NE(motion.conditions(), nullptr);
  EXPECT_NEAR(motion.conditions()->at({9.0, 6.0}).color_factor.x, 0.5f, 1e-6f) << "at once";
  const glm::vec3 before = motion.sway()->mean_tip({9.0, 6.0});
  world.step(kStepS);
  EXPECT_LT(glm::distance(motion.sway()->mean_tip({9.0, 6.0}), before), 0.25f * glm::length(before))
      << "no jump";
  for (int n = 0; n < 120; ++n) world.step(kStepS);
  EXPECT_LT(glm::length(motion.sway()->mean_tip({9.0, 6.0})), 0.6f * glm::length(before));
  EXPECT_THROW(motion.spawn(Condition{.radius_m = -1.0}), BadInput);
}

TEST(ConditionWorld, SpawningKeepsWhatTheSceneHas) {
  // Both are over when others are spawned, and a state brings back the time when they were not.
  World world = world_with(
      std::string(kWind) +
      "[[wind.gust]]\nposition_m = [0, 8]\nstrength_m_per_s = 9\nway_m = 4\n"
      "[[condition]]\ncentre_m = [9, 6]\nradius_m = 9\nduration_s = 1\ncolor_factor = [2, 1, 1]\n");
  Motion& motion = world.motion();
  motion.watch_anew({9.0, 6.0});
  for (int n = 0; n < 30; ++n) world.step(kStepS);
  const std::vector<std::byte> early = world.saved_state();
  for (int n = 0; n < 30; ++n) world.step(kStepS);
  const std::vector<std::byte> later = world.saved_state();
  for (int n = 0; n < 600; ++n) world.step(kStepS);
  const glm::dvec2 elsewhere_m(500.0, 500.0);
  for (int n = 0; n < 300; ++n) {
    motion.spawn(Gust{.origin_m = elsewhere_m, .start_s = -1e4});
    motion.spawn(Condition{
        .centre_m = elsewhere_m, .radius_m = 1.0, .edge_m = 1.0, .start_s = -10.0, .duration_s = 1.0});
  }
  world.load_state(early, "");
  EXPECT_EQ(motion.conditions()->at({9.0, 6.0}).color_factor.x, 2.0f);
  for (int n = 0; n < 30; ++n) world.step(kStepS);
  EXPECT_EQ(world.saved_state(), later);
}

TEST(ConditionWorld, GoesOnFromItsSavedStateBitForBit) {
  const std::string stone = "[[mover]]\nname = \"stone\"\npath_m = [[4, 8], [20, 9]]\n";
  for (const std::string& wind : {std::string(kWind), std::string()}) {
    const auto go = [](World& world, int first, int end) {
      for (int n = first; n < end; ++n) {
        world.motion().watch(glm::dvec2(9.0, 6.0) + glm::dvec2(0.03 * n, 0.0));
        world.step(kStepS);
      }
    };
    const std::string text = wind + kFrost + stone;
    World whole = world_with(text), first = world_with(text), second = world_with(text);
    go(whole, 0, 180);
    go(first, 0, 90);
    const std::vector<std::byte> between = first.saved_state();
    second.load_state(between, "");
    EXPECT_EQ(second.saved_state(), between);
    const auto equal = [](auto a, auto b) {
      return a.size_bytes() == b.size_bytes() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
    };
    EXPECT_TRUE(equal(second.motion().conditions()->image(), first.motion().conditions()->image()));
    EXPECT_TRUE(wind.empty() || equal(second.motion().sway()->image(), first.motion().sway()->image()));
    go(second, 90, 180);
    EXPECT_EQ(second.saved_state(), whole.saved_state());
    EXPECT_TRUE(equal(second.motion().conditions()->image(), whole.motion().conditions()->image()));
    EXPECT_GT(whole.motion().touched().size(), 0u);
    World other = world_with(wind + stone);
    EXPECT_THROW(other.load_state(between, ""), BadInput) << "of a scene without frost";
  }
}

}  // namespace
}  // namespace prairie
