#include "lod/planner.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "lod/cell_plan.h"
#include "lod/ground_quadtree.h"
#include "lod/strip_plan.h"
#include "lod/thinning.h"
#include "lod/tile_search.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// The ground is drawn to the horizon of a 2 m eye; haze takes the rest.
constexpr double kGroundFarM = 5000.0;
// Where every blade is asked for and the field repeats endlessly, this is where it ends.
constexpr double kAllBladesFarM = 1000.0;
// Strips nearer than this many of their sides follow the ground in several quads.
constexpr double kNearStripSides = 10.0;

bool draws_all(Tier tier) {
  return tier == Tier::kSpline || tier == Tier::kHermite;
}

/// Whether tiles may stand in strips.
bool may_morph(Tier tier, const Camera& camera) {
  return !draws_all(tier) && (!camera.is_orthographic() || tier == Tier::kStrip);
}

double far_of(const Meadow& meadow, const Camera& camera, const PlanOptions& options) {
  if (camera.is_orthographic()) return camera.orthographic_depth_m;
  if (!draws_all(options.tier)) return options.blade_distance_m;
  return meadow.repeats ? kAllBladesFarM : 1e9;
}

}  // namespace

Planner::Planner(const Meadow& meadow)
    : meadow_(&meadow), lattice_(meadow), longest_m_(longest_blades_m(meadow)) {
  tallest_blade_m_ = *std::max_element(longest_m_.begin(), longest_m_.end());
}

FramePlan Planner::plan(const Camera& camera, const PlanOptions& options) {
  FramePlan plan;
  plan.camera = camera;
  plan.lod_eye_m = options.lod_eye_m.value_or(camera.eye_m);
  plan.ground = ground_patches(*meadow_, camera, kGroundFarM);
  plan.lod = tier_coefficients(options.tier, options.quality, options.blade_distance_m, camera);
  if (options.tier == Tier::kFlat) return plan;

  TileSearch search(*meadow_, camera, plan.lod_eye_m, far_of(*meadow_, camera, options), tallest_blade_m_);
  const double quarters_far_m = draws_all(options.tier) ? 0.0 : CellPlan::quarters_far_m(plan.lod, camera);
  CellPlan cells(*meadow_, lattice_, longest_m_, search, quarters_far_m, plan);
  std::vector<StripTile> far_strips;
  const auto most_tiles = static_cast<std::size_t>(options.memory_budget_bytes / bytes_per_tile(lattice_));
  for (const SeenTile& seen : search.tiles(most_tiles)) {
    const float morph = may_morph(options.tier, camera) ? plan_strips(seen, plan, far_strips) : 0.0f;
    if (morph < 1.0f) cells.add_tile(seen.id, morph);
  }
  cells.finish();
  plan.near_strips = static_cast<std::uint32_t>(plan.strips.size());
  plan.strips.insert(plan.strips.end(), far_strips.begin(), far_strips.end());
  morphs_.finish();
  return plan;
}

/// Plans a tile's strips, the near ones in the plan, and returns how far it has morphed.
float Planner::plan_strips(const SeenTile& seen, FramePlan& plan, std::vector<StripTile>& far_strips) {
  Kernels kernels;
  const double tile_m = meadow_->tile_m;
  const glm::dvec2 centre_m = tile_origin_m(*meadow_, seen.id) + 0.5 * tile_m;
  const glm::dvec3 to_eye_m =
      plan.lod_eye_m - glm::dvec3(centre_m, static_cast<double>(meadow_->ground.height_m(centre_m)));
  const double distance_m = glm::length(to_eye_m);
  const float n_dot_r = glm::dot(meadow_->ground.normal(centre_m), glm::vec3(to_eye_m / distance_m));
  const float band = kernels.strip_band(plan.lod, static_cast<float>(distance_m));
  const float morph = morphs_.follow(seen.id, band, kernels.strip_grazing(plan.lod, n_dot_r));
  plan.morphs.push_back({seen.id.i, seen.id.j, morph});
  const float grown = kernels.strips_grown(morph);
  const double nearest_m = std::max(distance_m - tile_m, 0.0);
  if (grown <= 0.0f || kernels.sunk_share(plan.lod, static_cast<float>(nearest_m)) >= 1.0f) return morph;
  const TileDensity density = tile_density(*meadow_, seen.id);
  const bool is_near = seen.distance_m < kNearStripSides * tile_m;
  append_strips(*meadow_, seen.id, density, plan.camera.eye_m, grown, is_near ? plan.strips : far_strips);
  const auto standing = static_cast<std::uint64_t>(density.sum_per_m2() * tile_m * tile_m);
  plan.blades_in_strips += standing;
  if (morph >= 1.0f) plan.blades_planted_in_view += standing;
  return morph;
}

}  // namespace prairie
