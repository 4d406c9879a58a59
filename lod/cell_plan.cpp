#include "lod/cell_plan.h"

#include <algorithm>

#include "lod/cell_quarters.h"
#include "lod/thinning.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// Up to this distance, at the reference pixel, cells of enough blades are culled and thinned by quarters.
constexpr double kQuartersFarM = 12.0;
constexpr std::uint32_t kLeastInQuarters = 64;

/// The cell with its tables moved behind those that the plan holds.
PlantedCell moved(PlantedCell cell, std::uint32_t texels) {
  cell.ground_table += texels;
  cell.density_table += texels;
  if (cell.feature_table != kNoTable) cell.feature_table += texels;
  return cell;
}

}  // namespace

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

double CellPlan::quarters_far_m(const LodCoefficients& lod, const Camera& camera) {
  return kQuartersFarM * static_cast<double>(lod.reference_pixel) / camera.pixel_m();
}

CellPlan::CellPlan(const Meadow& meadow, const PlantingLattice& lattice, std::span<const double> longest_m,
                   const TileSearch& search, double quarters_far_m, FramePlan& plan)
    : meadow_(meadow),
      lattice_(lattice),
      longest_m_(longest_m),
      search_(search),
      quarters_far_m_(quarters_far_m),
      lod_camera_(plan.camera),
      plan_(plan) {
  lod_camera_.eye_m = plan.lod_eye_m;
}

void CellPlan::add_tile(TileId tile, float morph) {
  for (int cell = 0; cell < kCellsPerTile; ++cell) {
    if (search_.sees(search_.box_of_cell(tile, cell))) add_cell(tile, cell, morph);
  }
}

void CellPlan::add_cell(TileId tile, int cell, float morph) {
  tables_.cells.clear();
  tables_.tables.clear();
  append_cell(meadow_, lattice_, tile, cell, tables_);
  if (tables_.cells.empty()) return;
  const CellGround ground = ground_of(tile, cell);
  const glm::dvec3 corner_m(tile_origin_m(meadow_, tile), tile_base_m(meadow_, tile));
  const auto texels = static_cast<std::uint32_t>(plan_.tables.size() / 4);
  bool is_drawn = false;
  for (const PlantedCell& planted : tables_.cells) {
    plan_.blades_planted_in_view += planted.planted;
    DrawnCell drawn{};
    drawn.planted = moved(planted, texels);
    drawn.eye_from_tile_m = glm::vec3(corner_m - plan_.camera.eye_m);
    drawn.morph = morph;
    if (add_planted(planted, ground, drawn)) is_drawn = true;
  }
  if (is_drawn) plan_.tables.insert(plan_.tables.end(), tables_.tables.begin(), tables_.tables.end());
}

CellPlan::CellGround CellPlan::ground_of(TileId tile, int cell) const {
  const double side_m = meadow_.tile_m / kCellsPerSide;
  const double base_m = tile_base_m(meadow_, tile);
  const glm::dvec2 min_m = tile_origin_m(meadow_, tile) + glm::dvec2(cell_offset_m(meadow_, cell));
  const std::array<float, 9> heights_m = ground_heights_m(tables_, tables_.cells.front());
  const HeightRange range = ground_range(heights_m);
  return {min_m,
          heights_m,
          {glm::dvec3(min_m, base_m + static_cast<double>(range.min_m)),
           glm::dvec3(min_m + side_m, base_m + static_cast<double>(range.max_m))}};
}

/// Whether anything of it is drawn.
bool CellPlan::add_planted(const PlantedCell& planted, const CellGround& ground, DrawnCell drawn) {
  if (planted.planted < kLeastInQuarters || nearest_distance_m(ground.box, plan_.lod_eye_m) > quarters_far_m_)
    return add_roots(ground.box, ground, drawn);
  bool is_drawn = false;
  for (const CellQuarter& quarter : quarters_of(planted, tables_.tables)) {
    drawn.quarter = quarter.code;
    const AlignedBox roots{glm::dvec3(ground.min_m + glm::dvec2(quarter.min_m), ground.box.min_m.z),
                           glm::dvec3(ground.min_m + glm::dvec2(quarter.max_m), ground.box.max_m.z)};
    if (add_roots(roots, ground, drawn)) is_drawn = true;
  }
  return is_drawn;
}

/// Adds the blades whose roots lie in a box, as far as they are seen.
bool CellPlan::add_roots(const AlignedBox& roots, const CellGround& ground, DrawnCell drawn) {
  const PlantedCell& planted = drawn.planted;
  const SpeciesParams& params = meadow_.species[planted.species].species.params;
  const double reach_m = longest_m_[planted.species];
  if (!search_.sees({roots.min_m - glm::dvec3(reach_m, reach_m, 0.0), roots.max_m + reach_m})) return false;
  Kernels kernels;
  const double side_m = meadow_.tile_m / kCellsPerSide;
  const double keep =
      static_cast<double>(kernels.blades_left(drawn.morph) *
                          kernels.crowded_share(plan_.lod, kernels.mean_density_per_m2(planted))) *
      keep_bound(plan_.lod, lod_camera_, {roots, ground.heights_m, side_m}, params.width_m);
  const std::uint32_t bound = drawn_bound(planted, keep);
  drawn.drawn = drawn.quarter == 0 ? bound : drawn_in_quarter(drawn.quarter, bound);
  if (drawn.drawn == 0) return false;
  const double distance_m = nearest_distance_m(roots, plan_.lod_eye_m);
  const double pixel_m = lod_camera_.pixel_m_at(std::max(distance_m, 0.1));
  const bool is_spline = kernels.hermite_share(plan_.lod, static_cast<float>(distance_m)) < 1.0f;
  hermite_and_spline_[is_spline][segment_class(static_cast<double>(params.height_m) / pixel_m)].push_back(
      drawn);
  return true;
}

/// Which of kSegments suits a blade of so many pixels.
std::size_t CellPlan::segment_class(double blade_pixels) const {
  Kernels kernels;
  const float pixels = kernels.mesh_pixels(plan_.lod, static_cast<float>(blade_pixels));
  const auto suits = [&](std::uint32_t segments) {
    return pixels >= kernels.least_pixels(static_cast<int>(segments));
  };
  return static_cast<std::size_t>(std::ranges::find_if(kSegments, suits) - kSegments.begin());
}

void CellPlan::finish() {
  for (const bool is_spline : {true, false}) {
    for (std::size_t n = 0; n < kSegments.size(); ++n) {
      const std::vector<DrawnCell>& cells = hermite_and_spline_[is_spline][n];
      if (cells.empty()) continue;
      plan_.groups.push_back({is_spline, kSegments[n], static_cast<std::uint32_t>(plan_.cells.size()),
                              static_cast<std::uint32_t>(cells.size())});
      for (const DrawnCell& cell : cells) plan_.blades_drawn += cell.drawn;
      plan_.cells.insert(plan_.cells.end(), cells.begin(), cells.end());
    }
  }
}

}  // namespace prairie
