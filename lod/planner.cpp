#include "lod/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "lod/frustum.h"
#include "lod/ground_quadtree.h"
#include "lod/thinning.h"
#include "maps/error.h"

namespace prairie {
namespace {

// The ground is drawn to the horizon of a 2 m eye; haze takes the rest.
constexpr double kGroundFarM = 5000.0;
// Where every blade is asked for and the field repeats endlessly, this is where it ends.
constexpr double kAllBladesFarM = 1000.0;

struct SeenCell {
  TileId tile;
  int cell;
  double distance_m;
};

// Walks squares of 2^level cells from coarse to fine.
class CellSearch {
 public:
  CellSearch(const Meadow& meadow, const Camera& camera, double far_m, double blade_m)
      : meadow_(meadow),
        camera_(camera),
        frustum_(camera),
        far_m_(far_m),
        blade_m_(blade_m),
        cell_m_(meadow.tile_m / kCellsPerSide) {}

  /// Throws OverBudget where there are more than `most_cells`.
  std::vector<SeenCell> cells(std::size_t most_cells) {
    most_cells_ = most_cells;
    int level = 0;
    const double reach_m = std::min(far_m_, 2.0 * glm::length(meadow_.extent_m) + far_from_field_m());
    while (std::ldexp(cell_m_, level) < reach_m && level < 24) ++level;
    const double side_m = std::ldexp(cell_m_, level);
    const int x = static_cast<int>(std::floor(camera_.eye_m.x / side_m));
    const int y = static_cast<int>(std::floor(camera_.eye_m.y / side_m));
    for (int row = y - 1; row <= y + 1; ++row) {
      for (int column = x - 1; column <= x + 1; ++column) visit(level, column, row);
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const SeenCell& a, const SeenCell& b) { return a.distance_m < b.distance_m; });
    return std::move(found_);
  }

 private:
  double far_from_field_m() const {
    if (meadow_.repeats) return far_m_;
    const glm::dvec2 eye_m(camera_.eye_m);
    return glm::length(eye_m - glm::clamp(eye_m, glm::dvec2(0.0), meadow_.extent_m));
  }

  void visit(int level, int column, int row) {
    const double side_m = std::ldexp(cell_m_, level);
    const glm::dvec2 min_m = side_m * glm::dvec2(column, row);
    const glm::dvec2 max_m = min_m + side_m;
    if (!meadow_.repeats && (max_m.x <= 0.0 || max_m.y <= 0.0 || min_m.x >= meadow_.extent_m.x ||
                             min_m.y >= meadow_.extent_m.y)) {
      return;
    }
    const HeightRange ground = meadow_.ground.range(min_m, max_m);
    const Box box{glm::dvec3(min_m - blade_m_, ground.min_m),
                  glm::dvec3(max_m + blade_m_, static_cast<double>(ground.max_m) + blade_m_)};
    if (!frustum_.may_see(box)) return;
    const double distance_m = nearest_distance_m(box, camera_.eye_m);
    if (distance_m >= far_m_) return;
    if (level == 0) {
      if (found_.size() == most_cells_) {
        throw OverBudget("", "--max-memory", fmt::format("more than {} cells in view", most_cells_),
                         "a larger budget, a shorter lod.blade_distance_m or fewer tiles in view");
      }
      // Arithmetic shift and mask: floor and remainder for negative indices too.
      static_assert(kCellsPerSide == 2);
      found_.push_back({{column >> 1, row >> 1}, (row & 1) * kCellsPerSide + (column & 1), distance_m});
      return;
    }
    for (int child = 0; child < 4; ++child) visit(level - 1, 2 * column + child % 2, 2 * row + child / 2);
  }

  const Meadow& meadow_;
  const Camera& camera_;
  Frustum frustum_;
  double far_m_;
  double blade_m_;
  double cell_m_;
  std::vector<SeenCell> found_;
  std::size_t most_cells_ = 0;
};

constexpr std::array<std::uint32_t, 5> kSegments = {7, 5, 3, 2, 1};

// Segments that keep a bent blade smooth: about one for every dozen pixels of its length.
std::size_t segment_class(double blade_pixels) {
  constexpr std::array<double, 4> kLeastPixels = {90.0, 45.0, 20.0, 8.0};
  std::size_t n = 0;
  while (n < kLeastPixels.size() && blade_pixels < kLeastPixels[n]) ++n;
  return n;
}

// What a cell in view takes at most: prepared in the cache, and once more in the plan.
std::size_t bytes_per_cell(const PlantingLattice& lattice) {
  constexpr std::size_t kGroundTexels = 3;
  const auto features = static_cast<std::size_t>(lattice.feature_patches);
  std::size_t bytes =
      kTexelBytes * (kGroundTexels + (features > 0 ? 2 * (features + 1) * (features + 1) : 0));
  for (const int patches : lattice.density_patches) {
    const auto m = static_cast<std::size_t>(patches);
    bytes += sizeof(PlantedCell) + kTexelBytes * (m + m * (m + 1));
  }
  return 2 * bytes + lattice.density_patches.size() * sizeof(DrawnCell) + sizeof(SeenCell) +
         sizeof(CellTables);
}

}  // namespace

Planner::Planner(const Meadow& meadow)
    : meadow_(&meadow), cache_(meadow), tallest_blade_m_(tallest_blade_m(meadow)) {}

FramePlan Planner::plan(const Camera& camera, const PlanOptions& options) {
  FramePlan plan;
  plan.camera = camera;
  const bool all = options.tier == Tier::kHermite || options.tier == Tier::kSpline;
  plan.lod = all ? all_blades() : lod_coefficients(options.quality, options.blade_distance_m);
  plan.ground = ground_patches(*meadow_, camera, kGroundFarM);
  if (options.tier == Tier::kFlat || options.tier == Tier::kStrip) {
    // The ground stands for all blades.
    plan.lod.fade_start_m = -1.0f;
    plan.lod.fade_end_m = 0.0f;
    return plan;
  }

  const double far_m = camera.is_orthographic() ? camera.orthographic_depth_m
                       : !all                   ? options.blade_distance_m
                       : meadow_->repeats       ? kAllBladesFarM
                                                : 1e9;
  if (camera.is_orthographic() && !all) {
    // Distance is no matter in a parallel projection; only pixels are.
    plan.lod.fade_start_m = 1e9f;
    plan.lod.fade_end_m = 2e9f;
  }
  std::array<std::vector<DrawnCell>, kSegments.size()> classes;
  const double cell_m = meadow_->tile_m / kCellsPerSide;
  for (const SeenCell& seen :
       CellSearch(*meadow_, camera, far_m, tallest_blade_m_)
           .cells(static_cast<std::size_t>(options.memory_budget_bytes / bytes_per_cell(cache_.lattice())))) {
    const CellTables& tables = cache_.get(seen.tile, seen.cell);
    if (tables.cells.empty()) continue;
    const glm::dvec2 tile_m = tile_origin_m(*meadow_, seen.tile);
    const double base_m = tile_base_m(*meadow_, seen.tile);
    const glm::dvec2 min_m = tile_m + glm::dvec2(cell_offset_m(*meadow_, seen.cell));
    const std::array<float, 9> heights_m = ground_heights_m(tables, tables.cells.front());
    const HeightRange range = ground_range(heights_m);
    const Box ground{glm::dvec3(min_m, base_m + static_cast<double>(range.min_m)),
                     glm::dvec3(min_m + cell_m, base_m + static_cast<double>(range.max_m))};
    const double keep = keep_bound(plan.lod, camera, {ground, heights_m, cell_m});
    const double pixel_m = camera.pixel_m_at(std::max(seen.distance_m, 0.1));
    const auto texels = static_cast<std::uint32_t>(plan.tables.size() / 4);
    bool is_drawn = false;
    for (const PlantedCell& planted : tables.cells) {
      plan.blades_planted_in_view += planted.planted;
      const std::uint32_t drawn = drawn_bound(planted, keep);
      if (drawn == 0) continue;
      is_drawn = true;
      DrawnCell cell{};
      cell.planted = planted;
      cell.planted.ground_table += texels;
      cell.planted.density_table += texels;
      if (planted.feature_table != kNoTable) cell.planted.feature_table += texels;
      cell.eye_from_tile_m = glm::vec3(glm::dvec3(tile_m, base_m) - camera.eye_m);
      cell.drawn = drawn;
      const SpeciesParams& params = meadow_->species[planted.species].species.params;
      const std::size_t segments = segment_class(static_cast<double>(params.height_m) / pixel_m);
      cell.segments = kSegments[segments];
      classes[segments].push_back(cell);
    }
    if (is_drawn) plan.tables.insert(plan.tables.end(), tables.tables.begin(), tables.tables.end());
  }
  for (std::size_t n = 0; n < classes.size(); ++n) {
    if (classes[n].empty()) continue;
    plan.groups.push_back({kSegments[n], static_cast<std::uint32_t>(plan.cells.size()),
                           static_cast<std::uint32_t>(classes[n].size())});
    for (const DrawnCell& cell : classes[n]) plan.blades_drawn += cell.drawn;
    plan.cells.insert(plan.cells.end(), classes[n].begin(), classes[n].end());
  }
  cache_.end_frame();
  return plan;
}

}  // namespace prairie
