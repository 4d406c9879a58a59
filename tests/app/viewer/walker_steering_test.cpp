// A walker that a person steers, and what the overlay says of walkers.
#include "app/viewer/walker_steering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/viewer/walker_text.h"
#include "tests/app/viewer/walking_world.h"
#include "world/world.h"

namespace prairie {
namespace {

using testing::replaying_world;
using testing::walking_world;

void walk(World& world, WalkerSteering& steering, const WalkerControls& controls, double time_s) {
  for (double t = 0.0; t < time_s; t += 0.05) {
    steering.steer(controls);
    world.step(0.05);
  }
}

TEST(WalkerSteering, WalksAheadStandsAndHastens) {
  World world = walking_world();
  WalkerSteering steering(world);
  steering.toggle(2);
  ASSERT_EQ(steering.steered(), 2u);
  EXPECT_TRUE(world.crowd().is_steered(2));
  EXPECT_FALSE(world.crowd().is_steered(0));
  const Walker start = world.walkers()[2];
  walk(world, steering, {1.0, 0.0, false}, 3.0);
  const Walker walked = world.walkers()[2];
  EXPECT_NEAR(glm::dot(glm::normalize(walked.position_m - start.position_m), start.forward), 1.0, 1e-6);
  EXPECT_NEAR(walked.speed_m_per_s, world.walker_traits()[2].speed_m_per_s, 0.3);
  walk(world, steering, {1.0, 0.0, true}, 3.0);
  EXPECT_GT(world.walkers()[2].speed_m_per_s, 1.1 * walked.speed_m_per_s);
  EXPECT_LE(world.walkers()[2].speed_m_per_s, kFastWalkMPerS + 1e-9);
  walk(world, steering, {-1.0, 0.0, false}, 3.0);
  EXPECT_EQ(world.walkers()[2].speed_m_per_s, 0.0);
}

TEST(WalkerSteering, TurnsToEitherSide) {
  for (const double left : {1.0, -1.0}) {
    World world = walking_world();
    WalkerSteering steering(world);
    steering.toggle(2);
    const glm::dvec2 before = world.walkers()[2].forward;
    walk(world, steering, {0.0, left, false}, 0.5);
    const glm::dvec2 after = world.walkers()[2].forward;
    EXPECT_GT(left * (before.x * after.y - before.y * after.x), 0.4) << "turned by half a radian or more";
    EXPECT_NEAR(glm::distance(world.walkers()[2].position_m, glm::dvec2(32.0, 50.0)), 0.0, 0.1)
        << "on the spot";
    walk(world, steering, {0.0, 0.0, false}, 0.5);
    EXPECT_NEAR(glm::distance(world.walkers()[2].forward, after), 0.0, 1e-6) << "goes on turning";
  }
}

TEST(WalkerSteering, CommandsAreUnitHeadings) {
  const World world = walking_world();
  for (const double left : {-1.0, 0.0, 1.0}) {
    const MotorCommand command = command_of({0.0, left, true}, world.walkers()[0], world.walker_traits()[0]);
    EXPECT_NEAR(glm::length(command.heading), 1.0, 1e-9);
    EXPECT_EQ(command.speed_m_per_s, 0.0);
  }
}

TEST(WalkerSteering, GivesBackWhoIsNotWatchedAnyMore) {
  World world = walking_world();
  {
    WalkerSteering steering(world);
    EXPECT_FALSE(steering.toggle(std::nullopt).empty());
    EXPECT_FALSE(steering.steered());
    steering.toggle(0);
    steering.keep_only(0);
    EXPECT_TRUE(world.crowd().is_steered(0));
    steering.keep_only(1);
    EXPECT_FALSE(world.crowd().is_steered(0));
    steering.toggle(1);
    steering.toggle(1);
    EXPECT_FALSE(world.crowd().is_steered(1));
    steering.toggle(2);
  }
  EXPECT_FALSE(world.crowd().is_steered(2)) << "at the end";
}

TEST(WalkerSteering, RecordedWalkersGoTheirOwnWay) {
  World world = replaying_world();
  WalkerSteering steering(world);
  EXPECT_NE(steering.toggle(0).find("cannot be steered"), std::string::npos);
  EXPECT_FALSE(steering.steered());
  walk(world, steering, {-1.0, 0.0, false}, 2.0);
  EXPECT_NEAR(world.walkers()[0].position_m.x, 22.0, 0.1);
}

TEST(WalkerText, TellsOfTheWatchedWalker) {
  World world(testing::walking_scene(R"([[obstacle]]
kind = "trunk"
position_m = [31, 32]
radius_m = 0.5
[[walkers]]
name = "one"
starts_m = [[28, 32]]
)"),
              {});
  EXPECT_EQ(walkers_line(world), "1 walkers");
  WalkerSteering steering(world);
  EXPECT_NE(watched_walker_line(world, 0, world.percepts()).find("wander"), std::string::npos);
  steering.toggle(0);
  const std::string line = watched_walker_line(world, 0, world.percepts());
  EXPECT_NE(line.find("obstacle: d 2.2"), std::string::npos) << line;
  EXPECT_NE(line.find("steered"), std::string::npos) << line;
  const World recorded = replaying_world();
  EXPECT_EQ(walkers_line(recorded), "1 of 2 walkers");
  EXPECT_NE(watched_walker_line(recorded, 1, {}).find("not there now"), std::string::npos);
  EXPECT_EQ(walkers_line(World(testing::walking_scene(""), {})), "");
}

TEST(WalkerText, AnglesToTheLeftArePositive) {
  Percept percept;
  percept.toward = {0.0, 1.0};
  EXPECT_NEAR(angle_to_percept_rad(percept, {1.0, 0.0}), std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(angle_to_percept_rad(percept, {-1.0, 0.0}), -std::numbers::pi / 2.0, 1e-12);
}

}  // namespace
}  // namespace prairie
