// Plans frames: culls the tile quadtree against the camera, bounds how many blades each cell shows, and lays
// them out for the renderer (docs/design.md, D3). Keeps prepared cells from frame to frame; the plan depends
// on camera and meadow alone.
#pragma once

#include <cstdint>
#include <limits>

#include "generator/meadow.h"
#include "lod/cell_cache.h"
#include "lod/frame_plan.h"
#include "lod/quality.h"

namespace prairie {

struct PlanOptions {
  Tier tier = Tier::kAuto;
  Quality quality = Quality::kMedium;
  double blade_distance_m = 120.0;
  std::uint64_t memory_budget_bytes = std::numeric_limits<std::uint64_t>::max();  // for cells and plan
};

class Planner {
 public:
  explicit Planner(const Meadow& meadow);

  /// Throws OverBudget where the cells in view would need more memory than the budget, before it is spent.
  FramePlan plan(const Camera& camera, const PlanOptions& options);

 private:
  const Meadow* meadow_;
  CellCache cache_;
  double tallest_blade_m_;
};

}  // namespace prairie
