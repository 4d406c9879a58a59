// How a frame is drawn, and what it drew.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "lod/frame_plan.h"
#include "lod/quality.h"
#include "render/gl/stage_time.h"
#include "render/overlays/field_overlay.h"
#include "render/overlays/line_segment.h"

namespace prairie {

struct FrameOptions {
  Tier tier = Tier::kAuto;
  bool msaa = false;  // 4 samples per pixel
  std::uint64_t memory_budget_bytes =
      std::numeric_limits<std::uint64_t>::max();  // for the plan (lod/planner.h)
  std::optional<Quality> quality = {};            // the scene's, if not given
  std::optional<glm::dvec3> lod_eye_m = {};       // tiers are chosen for this eye; the camera's, if not given
  bool tier_tint = false;  // colours each tier: spline red, Hermite yellow, strips green, flat blue
  FieldOverlay field_overlay = FieldOverlay::kNone;
  std::span<const LineSegment> lines = {};  // drawn over the picture; not owned
};

/// What one tier of a frame draws.
struct TierStatistics {
  std::uint64_t blades = 0;  // of strips and the flat tier: those they stand for
  std::uint64_t triangles = 0;
};

struct FrameStatistics {
  std::uint64_t blades_planted_in_view = 0;  // of the cells that the plan holds, before thinning
  std::uint64_t blades_drawn = 0;            // as 3D blades
  std::uint64_t triangles = 0;
  TierStatistics spline, hermite, strip, flat;
  double plan_ms = 0.0;
  std::vector<StageTime> gpu_times;  // by pass, of a frame some frames ago
};

}  // namespace prairie
