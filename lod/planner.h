// Plans frames: culls the tile quadtree against the camera, chooses each tile's tier and morph, bounds how
// many blades each cell shows, and lays all out for the renderer (docs/design.md, D3).
//
// Tiles morph with a little play (lod/tile_morphs.h): a new planner's first plan depends on camera and meadow
// alone, later ones by that much on the one before.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "generator/cell_table.h"
#include "generator/meadow.h"
#include "lod/frame_plan.h"
#include "lod/quality.h"
#include "lod/tile_morphs.h"
#include "lod/tile_search.h"

namespace prairie {

struct PlanOptions {
  Tier tier = Tier::kAuto;
  Quality quality = Quality::kMedium;
  double blade_distance_m = 120.0;
  std::uint64_t memory_budget_bytes = std::numeric_limits<std::uint64_t>::max();  // for cells and plan
  std::optional<glm::dvec3> lod_eye_m = {};  // tiers are chosen for this eye; the camera's, if not given
};

class Planner {
 public:
  explicit Planner(const Meadow& meadow);

  /// Throws OverBudget where the tiles in view would need more memory than the budget, before it is spent.
  FramePlan plan(const Camera& camera, const PlanOptions& options);

  /// Makes the next plan a first one.
  void forget() { morphs_.forget(); }

 private:
  float plan_strips(const SeenTile& seen, FramePlan& plan, std::vector<StripTile>& far_strips);

  const Meadow* meadow_;
  PlantingLattice lattice_;
  std::vector<double> longest_m_;  // blade of each species
  double tallest_blade_m_ = 0.0;
  TileMorphs morphs_;
};

}  // namespace prairie
