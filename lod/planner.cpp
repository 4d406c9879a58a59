#include "lod/planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "lod/cell_quarters.h"
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
// How far a morphing tile lags behind the eye.
constexpr float kPlay = 0.02f;
// Strips nearer than this many of their sides follow the ground in several quads.
constexpr double kNearStripSides = 10.0;

// Up to this distance, at the reference pixel, cells of enough blades are culled and thinned by quarters.
constexpr double kQuartersFarM = 12.0;
constexpr std::uint32_t kLeastInQuarters = 64;

constexpr std::array<std::uint32_t, 4> kSegments = {8, 4, 2, 1};

// Which of kSegments suits a blade of so many pixels.
std::size_t segment_class(const LodCoefficients& lod, double blade_pixels) {
  Kernels kernels;
  const float pixels = kernels.mesh_pixels(lod, static_cast<float>(blade_pixels));
  const auto suits = [&](std::uint32_t segments) {
    return pixels >= kernels.least_pixels(static_cast<int>(segments));
  };
  return static_cast<std::size_t>(std::ranges::find_if(kSegments, suits) - kSegments.begin());
}

// What a tile in view takes at most: four cells made ready, once more in the plan, and its strips.
std::size_t bytes_per_tile(const PlantingLattice& lattice) {
  constexpr std::size_t kGroundTexels = 3;
  const auto features = static_cast<std::size_t>(lattice.feature_patches);
  std::size_t bytes =
      kTexelBytes * (kGroundTexels + (features > 0 ? 2 * (features + 1) * (features + 1) : 0));
  for (const int patches : lattice.density_patches) {
    const auto m = static_cast<std::size_t>(patches);
    bytes += sizeof(DrawnCell) + kTexelBytes * (m + m * (m + 1));
  }
  return kCellsPerTile * 2 * bytes + lattice.density_patches.size() * sizeof(StripTile) + sizeof(SeenTile);
}

std::uint64_t key_of(TileId tile) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(tile.j)) << 32) |
         static_cast<std::uint32_t>(tile.i);
}

// Cells of one mesh.
struct MeshCells {
  std::array<std::array<std::vector<DrawnCell>, kSegments.size()>, 2> hermite_and_spline;

  void append_to(FramePlan& plan) const {
    for (const bool is_spline : {true, false}) {
      for (std::size_t n = 0; n < kSegments.size(); ++n) {
        const std::vector<DrawnCell>& cells = hermite_and_spline[is_spline][n];
        if (cells.empty()) continue;
        plan.groups.push_back({is_spline, kSegments[n], static_cast<std::uint32_t>(plan.cells.size()),
                               static_cast<std::uint32_t>(cells.size())});
        for (const DrawnCell& cell : cells) plan.blades_drawn += cell.drawn;
        plan.cells.insert(plan.cells.end(), cells.begin(), cells.end());
      }
    }
  }
};

double far_of(const Meadow& meadow, const Camera& camera, const PlanOptions& options, bool all) {
  if (camera.is_orthographic()) return camera.orthographic_depth_m;
  if (!all) return options.blade_distance_m;
  return meadow.repeats ? kAllBladesFarM : 1e9;
}

}  // namespace

Planner::Planner(const Meadow& meadow)
    : meadow_(&meadow), lattice_(meadow), longest_m_(longest_blades_m(meadow)) {
  tallest_blade_m_ = *std::max_element(longest_m_.begin(), longest_m_.end());
}

float Planner::morph_of(std::uint64_t tile_key, float band, float grazing) {
  // Past 0 and 1 by the play, so that both are reached.
  float morph = std::clamp(band, -kPlay, grazing < 1.0f ? 1.0f : 1.0f + kPlay) * grazing;
  if (morph > -kPlay && morph < 1.0f + kPlay) {
    if (const auto last = morphs_.find(tile_key); last != morphs_.end()) {
      morph = std::clamp(last->second, morph - kPlay, morph + kPlay);
    }
    next_morphs_[tile_key] = morph;
  }
  return std::clamp(morph, 0.0f, 1.0f);
}

FramePlan Planner::plan(const Camera& camera, const PlanOptions& options) {
  FramePlan plan;
  plan.camera = camera;
  plan.lod_eye_m = options.lod_eye_m.value_or(camera.eye_m);
  plan.ground = ground_patches(*meadow_, camera, kGroundFarM);
  plan.lod = tier_coefficients(options.tier, options.quality, options.blade_distance_m, camera);
  if (options.tier == Tier::kFlat) return plan;

  Camera lod_camera = camera;
  lod_camera.eye_m = plan.lod_eye_m;
  const bool all = options.tier == Tier::kSpline || options.tier == Tier::kHermite;
  const double far_m = far_of(*meadow_, camera, options, all);
  const double cell_m = meadow_->tile_m / kCellsPerSide;
  const double quarters_far_m =
      all ? 0.0 : kQuartersFarM * static_cast<double>(plan.lod.reference_pixel) / camera.pixel_m();
  Kernels kernels;
  MeshCells meshes;
  std::vector<StripTile> far_strips;
  CellTables tables;
  next_morphs_.clear();
  TileSearch search(*meadow_, camera, plan.lod_eye_m, far_m, tallest_blade_m_);
  const std::size_t most_tiles =
      static_cast<std::size_t>(options.memory_budget_bytes / bytes_per_tile(lattice_));
  for (const SeenTile& seen : search.tiles(most_tiles)) {
    const glm::dvec2 origin_m = tile_origin_m(*meadow_, seen.id);
    float morph = 0.0f;
    if (!all && (!camera.is_orthographic() || options.tier == Tier::kStrip)) {
      const glm::dvec2 centre_m = origin_m + 0.5 * meadow_->tile_m;
      const glm::dvec3 to_eye_m =
          plan.lod_eye_m - glm::dvec3(centre_m, static_cast<double>(meadow_->ground.height_m(centre_m)));
      const double distance_m = glm::length(to_eye_m);
      const float n_dot_r = glm::dot(meadow_->ground.normal(centre_m), glm::vec3(to_eye_m / distance_m));
      const float band = kernels.strip_band(plan.lod, static_cast<float>(distance_m));
      morph = morph_of(key_of(seen.id), band, kernels.strip_grazing(plan.lod, n_dot_r));
      plan.morphs.push_back({seen.id.i, seen.id.j, morph});
      const float grown = kernels.strips_grown(morph);
      const double nearest_m = std::max(distance_m - meadow_->tile_m, 0.0);
      if (grown > 0.0f && kernels.sunk_share(plan.lod, static_cast<float>(nearest_m)) < 1.0f) {
        const TileDensity density = tile_density(*meadow_, seen.id);
        const bool is_near = seen.distance_m < kNearStripSides * meadow_->tile_m;
        append_strips(*meadow_, seen.id, density, camera.eye_m, grown, is_near ? plan.strips : far_strips);
        const double standing = density.sum_per_m2() * meadow_->tile_m * meadow_->tile_m;
        plan.blades_in_strips += static_cast<std::uint64_t>(standing);
        if (morph >= 1.0f) plan.blades_planted_in_view += static_cast<std::uint64_t>(standing);
      }
      if (morph >= 1.0f) continue;
    }
    const double base_m = tile_base_m(*meadow_, seen.id);
    for (int cell = 0; cell < kCellsPerTile; ++cell) {
      if (!search.sees(search.box_of_cell(seen.id, cell))) continue;
      tables.cells.clear();
      tables.tables.clear();
      append_cell(*meadow_, lattice_, seen.id, cell, tables);
      if (tables.cells.empty()) continue;
      const glm::dvec2 min_m = origin_m + glm::dvec2(cell_offset_m(*meadow_, cell));
      const std::array<float, 9> heights_m = ground_heights_m(tables, tables.cells.front());
      const HeightRange range = ground_range(heights_m);
      const AlignedBox ground{glm::dvec3(min_m, base_m + static_cast<double>(range.min_m)),
                              glm::dvec3(min_m + cell_m, base_m + static_cast<double>(range.max_m))};
      const auto texels = static_cast<std::uint32_t>(plan.tables.size() / 4);
      bool is_drawn = false;
      for (const PlantedCell& planted : tables.cells) {
        plan.blades_planted_in_view += planted.planted;
        const SpeciesParams& params = meadow_->species[planted.species].species.params;
        const double reach_m = static_cast<double>(longest_m_[planted.species]);
        DrawnCell drawn_cell{};
        drawn_cell.planted = planted;
        drawn_cell.planted.ground_table += texels;
        drawn_cell.planted.density_table += texels;
        if (planted.feature_table != kNoTable) drawn_cell.planted.feature_table += texels;
        drawn_cell.eye_from_tile_m = glm::vec3(glm::dvec3(origin_m, base_m) - camera.eye_m);
        drawn_cell.morph = morph;
        const auto add_roots_in = [&](const AlignedBox& roots) {
          const AlignedBox blades{roots.min_m - glm::dvec3(reach_m, reach_m, 0.0), roots.max_m + reach_m};
          if (!search.sees(blades)) return;
          const double keep =
              static_cast<double>(kernels.blades_left(morph) *
                                  kernels.crowded_share(plan.lod, kernels.mean_density_per_m2(planted))) *
              keep_bound(plan.lod, lod_camera, {roots, heights_m, cell_m}, params.width_m);
          const std::uint32_t drawn = drawn_bound(planted, keep);
          drawn_cell.drawn = drawn_cell.quarter == 0 ? drawn : drawn_in_quarter(drawn_cell.quarter, drawn);
          if (drawn_cell.drawn == 0) return;
          is_drawn = true;
          const double distance_m = nearest_distance_m(roots, plan.lod_eye_m);
          const double pixel_m = lod_camera.pixel_m_at(std::max(distance_m, 0.1));
          const bool is_spline = kernels.hermite_share(plan.lod, static_cast<float>(distance_m)) < 1.0f;
          const std::size_t segments =
              segment_class(plan.lod, static_cast<double>(params.height_m) / pixel_m);
          meshes.hermite_and_spline[is_spline][segments].push_back(drawn_cell);
        };
        if (planted.planted < kLeastInQuarters ||
            nearest_distance_m(ground, plan.lod_eye_m) > quarters_far_m) {
          add_roots_in(ground);
          continue;
        }
        for (const CellQuarter& quarter : quarters_of(planted, tables.tables)) {
          drawn_cell.quarter = quarter.code;
          add_roots_in({glm::dvec3(min_m + glm::dvec2(quarter.min_m), ground.min_m.z),
                        glm::dvec3(min_m + glm::dvec2(quarter.max_m), ground.max_m.z)});
        }
      }
      if (is_drawn) plan.tables.insert(plan.tables.end(), tables.tables.begin(), tables.tables.end());
    }
  }
  meshes.append_to(plan);
  plan.near_strips = static_cast<std::uint32_t>(plan.strips.size());
  plan.strips.insert(plan.strips.end(), far_strips.begin(), far_strips.end());
  morphs_.swap(next_morphs_);
  return plan;
}

}  // namespace prairie
