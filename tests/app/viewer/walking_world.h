// Level ground with walkers on it, and hardly any grass.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "agents/track.h"
#include "world/scene/scene.h"
#include "world/world.h"

namespace prairie::testing {

inline Scene walking_scene(const std::string& more) {
  const std::string scene = R"(version = 1
[ground]
size_m = [64, 64]
[[species]]
name = "grass"
density = 5
)";
  return parse_scene(scene + more, ".", {});
}

/// Two walkers on one line, 10 m apart, and a third aside.
inline World walking_world() {
  return World(walking_scene(R"([[walkers]]
name = "three"
starts_m = [[20, 32], [30, 32], [32, 50]]
)"),
               {});
}

/// One that walks east at 1 m/s from (20, 32), and one that is there 5 s later, at (40, 40).
inline World replaying_world() {
  World world(walking_scene(""), {});
  world.replay(
      {{1, {0.0, 10.0}, {{20.0, 32.0}, {30.0, 32.0}}}, {2, {5.0, 10.0}, {{40.0, 40.0}, {45.0, 40.0}}}});
  return world;
}

}  // namespace prairie::testing
