// How the viewer begins, and when it ends by itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "lod/frame_plan.h"

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

}  // namespace prairie
