// Lines about walkers: sensors, nearest obstacles and paths lie where they are, and are bounded in number.
#include "app/viewer/walker_overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>

#include "tests/app/viewer/walking_world.h"
#include "world/world.h"

namespace prairie {
namespace {

using testing::replaying_world;
using testing::walking_scene;
using testing::walking_world;

constexpr glm::dvec3 kEyeM(32.0, 20.0, 3.0);

World world_with_trunk() {
  return World(walking_scene(R"([[obstacle]]
kind = "trunk"
position_m = [31, 32]
radius_m = 0.5
[[walkers]]
name = "two"
starts_m = [[28, 32], [50, 50]]
)"),
               {});
}

World crowded_world() {
  return World(walking_scene(R"([[walkers]]
name = "many"
count = 260
position_m = [32, 32]
radius_m = 20
)"),
               {});
}

double above_ground_m(const World& world, glm::dvec3 place_m) {
  return place_m.z - static_cast<double>(world.meadow().ground.height_m(glm::dvec2(place_m)));
}

TEST(WalkerOverlay, CirclesReachAsFarAsSensors) {
  const World world = world_with_trunk();
  const std::vector<LineSegment> lines = sensor_lines(world, world.percepts(), kEyeM);
  const WalkerTraits& traits = world.walker_traits()[0];
  ASSERT_GE(lines.size(), 2 * kCircleSegments);
  for (std::size_t n = 0; n < kCircleSegments; ++n) {
    const LineSegment& line = lines[n];
    EXPECT_NEAR(glm::distance(glm::dvec2(line.from_m), {28.0, 32.0}), traits.radius_m + traits.sensor_m,
                1e-9);
    EXPECT_NEAR(above_ground_m(world, line.from_m), kLineAboveGroundM, 1e-9);
    EXPECT_EQ(line.to_m, lines[n + 1 < kCircleSegments ? n + 1 : 0].from_m) << "closed";
    EXPECT_GT(line.color.x, 5.0f * line.color.y) << "red";
  }
}

TEST(WalkerOverlay, ALineLeadsToTheNearestObstacle) {
  const World world = world_with_trunk();
  const std::vector<LineSegment> lines = sensor_lines(world, world.percepts(), kEyeM);
  // 2.25 m in pieces of a metre at most; the other walker perceives nothing.
  ASSERT_EQ(lines.size(), 2 * kCircleSegments + 3);
  const LineSegment& first = lines[kCircleSegments];
  const LineSegment& last = lines[kCircleSegments + 2];
  const double radius_m = world.walker_traits()[0].radius_m;
  EXPECT_NEAR(glm::distance(glm::dvec2(first.from_m), {28.0 + radius_m, 32.0}), 0.0, 1e-6);
  EXPECT_NEAR(glm::distance(glm::dvec2(last.to_m), {30.5, 32.0}), 0.0, 1e-6);
  EXPECT_EQ(first.to_m, lines[kCircleSegments + 1].from_m);
}

TEST(WalkerOverlay, RecordedWalkersHaveNoSensors) {
  const World world = replaying_world();
  EXPECT_TRUE(sensor_lines(world, world.percepts(), kEyeM).empty());
}

TEST(WalkerOverlay, ShowsTheNearestOfMany) {
  const World world = crowded_world();
  const std::vector<std::uint32_t> nearest = nearest_walkers(world, kEyeM, kMostOverlaidWalkers);
  ASSERT_EQ(nearest.size(), kMostOverlaidWalkers);
  EXPECT_TRUE(std::is_sorted(nearest.begin(), nearest.end()));
  const auto far_m = [&](std::size_t n) {
    return glm::distance(world.walkers()[n].position_m, glm::dvec2(kEyeM));
  };
  double farthest_m = 0.0;
  for (const std::uint32_t n : nearest) farthest_m = std::max(farthest_m, far_m(n));
  for (std::uint32_t n = 0; n < 260; ++n) {
    if (std::binary_search(nearest.begin(), nearest.end(), n)) continue;
    EXPECT_GE(far_m(n), farthest_m);
  }
  EXPECT_EQ(nearest_walkers(world, kEyeM, 1000).size(), 260u);
  EXPECT_LE(sensor_lines(world, world.percepts(), kEyeM).size(),
            kMostOverlaidWalkers * (kCircleSegments + 10));
}

TEST(WalkerTrails, LeadToWhereWalkersAre) {
  World world = walking_world();
  WalkerTrails trails;
  EXPECT_TRUE(path_lines(world, trails, kEyeM).empty());
  const glm::dvec2 start_m = world.walkers()[0].position_m;
  trails.follow(world, kEyeM);
  for (int n = 0; n < 100; ++n) {
    world.step(0.05);
    trails.follow(world, kEyeM);
  }
  EXPECT_EQ(trails.samples().size(), 21u);
  const std::vector<LineSegment> lines = path_lines(world, trails, kEyeM);
  ASSERT_FALSE(lines.empty());
  EXPECT_LE(lines.size(), 21u * 3u);
  // The first walker's pieces join from where it started to where it is.
  glm::dvec2 end_m = start_m;
  for (const LineSegment& line : lines) {
    EXPECT_NEAR(above_ground_m(world, line.from_m), kLineAboveGroundM, 1e-9);
    if (glm::dvec2(line.from_m) == end_m) end_m = glm::dvec2(line.to_m);
  }
  EXPECT_EQ(end_m, world.walkers()[0].position_m);
  EXPECT_LT(lines.front().color.w, lines.back().color.w) << "the older the fainter";
}

TEST(WalkerTrails, KeepAMinute) {
  World world = replaying_world();
  WalkerTrails trails;
  while (world.time_s() < 75.0) {
    world.step(0.1);
    trails.follow(world, kEyeM);
  }
  const double oldest_s = trails.samples().front().time_s;
  EXPECT_GE(oldest_s, world.time_s() - WalkerTrails::kLengthS - 1e-9);
  EXPECT_LT(oldest_s, world.time_s() - WalkerTrails::kLengthS + 0.5);
  EXPECT_LE(trails.samples().size(), 241u);
  EXPECT_TRUE(path_lines(world, trails, kEyeM).empty()) << "of those who have gone";
}

TEST(WalkerTrails, HoldTheNearestAlone) {
  World world = crowded_world();
  WalkerTrails trails;
  for (int n = 0; n < 20; ++n) {
    trails.follow(world, {0.0, 3.0 * n, 2.0});
    world.step(0.1);
  }
  for (const WalkerTrails::Sample& sample : trails.samples())
    EXPECT_EQ(sample.places.size(), kMostOverlaidWalkers);
  // Whoever was out of a sample has no piece that skips it.
  for (const LineSegment& line : path_lines(world, trails, kEyeM))
    EXPECT_LT(glm::distance(line.from_m, line.to_m), 1.3);
}

TEST(WalkerOverlay, CyclesThroughAll) {
  WalkerOverlay overlay = WalkerOverlay::kNone;
  std::string names;
  for (int n = 0; n < 4; ++n) {
    overlay = next_walker_overlay(overlay);
    names += std::string(walker_overlay_name(overlay)) + (shows_sensors(overlay) ? " s" : "") +
             (shows_paths(overlay) ? " p" : "") + ";";
  }
  EXPECT_EQ(names, "sensors s;paths p;sensors and paths s p;none;");
}

}  // namespace
}  // namespace prairie
