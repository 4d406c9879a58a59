// A square of 50 m with trunks, boxes, rocks and a wall that is not convex and has a hole: what the crowd's
// tests walk in.
#pragma once

#include <cstdint>
#include <vector>

#include "agents/crowd.h"
#include "agents/obstacle.h"

namespace prairie {

struct CrowdScene : StandingThings {
  HeightField ground;
};

/// Twenty obstacles; a dead end in the north-west, a room with a door in the south-east, a hole in the
/// middle.
inline CrowdScene crowd_scene() {
  CrowdScene scene;
  for (int n = 0; n < 8; ++n)
    scene.obstacles.push_back(Trunk{{6.0 + 5.3 * n, 10.0 + (n * 7) % 23}, 0.15 + 0.05 * (n % 4), 4.0});
  for (int n = 0; n < 6; ++n)
    scene.obstacles.push_back(
        Block{{8.0 + 6.1 * n, 36.0 - (n * 5) % 13}, {1.0 + 0.4 * n, 0.8, 1.0}, 0.4 * n});
  for (std::uint32_t n = 0; n < 6; ++n)
    scene.obstacles.push_back(Rock{{7.0 + 6.7 * n, 5.0 + (n * 3) % 5}, {1.6, 1.2, 0.9}, 0.7 * n, n + 1});
  scene.walls.push_back(Wall{{{{0, 0}, {50, 0}, {50, 50}, {22, 50}, {22, 42}, {18, 42}, {18, 50}, {0, 50}},
                              {{{24, 22}, {30, 21}, {29, 27}, {26, 24}}}},
                             WallSide::kInside,
                             0.0});
  scene.walls.push_back(Wall{{{{38, 6},
                               {46, 6},
                               {46, 14},
                               {38, 14},
                               {38, 11},
                               {38.4, 11},
                               {38.4, 13.6},
                               {45.6, 13.6},
                               {45.6, 6.4},
                               {38.4, 6.4},
                               {38.4, 9},
                               {38, 9}},
                              {}},
                             WallSide::kOutside,
                             1.0});
  return scene;
}

inline Crowd crowd_of(const CrowdScene& scene, std::uint32_t count, std::uint64_t seed) {
  WalkerGroup group;
  group.name = "people";
  group.count = count;
  group.centre_m = {25.0, 25.0};
  group.radius_m = 24.0;
  return Crowd({&group, 1}, footprints_of(scene, scene.ground), recorded_gait(), seed);
}

}  // namespace prairie
