// The viewer: a window in which a person flies over the meadow or walks through it while it moves, and plays
// with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>

#include "lod/camera.h"
#include "lod/frame_plan.h"
#include "world/world.h"

namespace prairie {

struct ViewerOptions {
  Tier tier = Tier::kAuto;
  bool msaa = false;
  bool paused = false;  // at first
  std::optional<std::size_t>
      follow;  // the walker that the camera follows at first; nobody where there is no such walker
  bool walker_overlay = false;            // what walkers perceive and their paths are shown at first
  std::uint64_t memory_budget_bytes = 0;  // for what a frame plans
  std::optional<int> frames;              // closes itself after so many, of those that are seen
  std::optional<std::filesystem::path> screenshot;  // of the last of those frames
};

/// Shows the world, which goes on meanwhile, until the window is closed. After a reset of the graphics device
/// it goes on in a new window. Throws NoSuitableOpenGl, OverBudget; LostContext if the first frame in a new
/// window is lost, too.
void view_world(World& world, const Camera& start, const ViewerOptions& options);

}  // namespace prairie
