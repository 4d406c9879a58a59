// The viewer: a window in which a person flies over the meadow or walks through it.
#pragma once

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
  std::optional<int> frames;                        // closes itself after so many
  std::optional<std::filesystem::path> screenshot;  // of the last of those frames
};

/// Shows the world until the window is closed. Throws NoSuitableOpenGl.
void view_world(const World& world, const Camera& start, const ViewerOptions& options);

}  // namespace prairie
