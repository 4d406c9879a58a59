// The plan of a frame: nothing that is seen is missing, and nothing in it depends on what was drawn before.
#include "lod/planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <map>
#include <random>

#include "files/error.h"
#include "generator/cell_table.h"
#include "generator/plant_cell.h"
#include "generator/tiles.h"
#include "lod/frustum.h"
#include "shaders/kernels/kernels.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr double kExtentM = 40.0;

Camera camera_at(glm::dvec3 eye_m, double yaw_rad, double pitch_rad) {
  Camera camera;
  camera.eye_m = eye_m;
  camera.yaw_rad = yaw_rad;
  camera.pitch_rad = pitch_rad;
  camera.size_px = {400, 300};
  return camera;
}

Camera random_camera(const Meadow& meadow, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const glm::dvec2 place = kExtentM * (1.4 * glm::dvec2(unit(random), unit(random)) - 0.2);
  const double above_m = 0.3 + 8.0 * std::pow(unit(random), 2.0);
  return camera_at({place, static_cast<double>(meadow.ground.height_m(place)) + above_m},
                   6.2832 * unit(random), 0.3 - 1.2 * unit(random));
}

struct Key {
  std::uint32_t sequence;
  std::uint32_t species;
  auto operator<=>(const Key&) const = default;
};

/// Which blades of each cell the plan draws.
std::map<Key, std::vector<bool>> drawn_by_cell(const FramePlan& plan) {
  std::map<Key, std::vector<bool>> drawn;
  Kernels kernels;
  for (const DrawnCell& cell : plan.cells) {
    std::vector<bool>& blades = drawn[{cell.planted.key.x, cell.planted.species}];
    blades.resize(cell.planted.planted);
    for (std::uint32_t n = 0; n < cell.drawn; ++n) {
      const std::uint32_t k = kernels.quarter_index(cell.quarter, n);
      EXPECT_LT(k, cell.planted.planted);
      EXPECT_FALSE(blades[k]) << "a blade comes twice";
      blades[k] = true;
    }
  }
  return drawn;
}

bool sees(const Camera& camera, glm::vec3 from_eye_m) {
  const glm::vec4 clip = camera.clip_from_eye() * glm::vec4(from_eye_m, 1.0f);
  return clip.w > 0.0f && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w && clip.z < clip.w;
}

/// How far a tile has morphed in a planner's first plan.
float morph_of(const Meadow& meadow, const FramePlan& plan, TileId tile) {
  const glm::dvec2 centre_m = tile_origin_m(meadow, tile) + 0.5 * meadow.tile_m;
  const glm::dvec3 to_eye_m =
      plan.lod_eye_m - glm::dvec3(centre_m, static_cast<double>(meadow.ground.height_m(centre_m)));
  const double distance_m = glm::length(to_eye_m);
  Kernels kernels;
  return kernels.strip_morph(plan.lod, kernels.strip_band(plan.lod, static_cast<float>(distance_m)),
                             glm::dot(meadow.ground.normal(centre_m), glm::vec3(to_eye_m / distance_m)));
}

/// Plants and poses every blade of the meadow as shaders/pass/grow.comp does, and asks of each that shows
/// anything whether the plan draws it. Returns how many show.
int expect_seen_blades_planned(const Meadow& meadow, const Camera& camera, const PlanOptions& options) {
  const FramePlan plan = Planner(meadow).plan(camera, options);
  const std::map<Key, std::vector<bool>> drawn = drawn_by_cell(plan);
  const PlantingLattice lattice(meadow);
  const auto pixel = static_cast<float>(camera.pixel_m());
  int shown = 0, missing = 0;
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      CellTables tables;
      for (int cell = 0; cell < kCellsPerTile; ++cell) append_cell(meadow, lattice, {i, j}, cell, tables);
      const glm::vec3 eye_from_tile_m(glm::dvec3(tile_origin_m(meadow, {i, j}), tile_base_m(meadow, {i, j})) -
                                      camera.eye_m);
      Kernels kernels{tables.tables.data()};
      for (const PlantedCell& cell : tables.cells) {
        std::vector<Blade> blades(cell.planted);
        plant_cell(cell, meadow.species[cell.species].species.params, tables.tables, blades);
        const auto entry = drawn.find({cell.key.x, cell.species});
        const float left = kernels.blades_left(morph_of(meadow, plan, {i, j}));
        for (std::uint32_t k = 0; k < cell.planted; ++k) {
          if (entry != drawn.end() && entry->second[k]) {
            ++shown;
            continue;
          }
          const Blade& blade = blades[k];
          const auto ground =
              kernels.ground_in_cell(cell.ground_table, cell.side_m, blade.root_m - cell.offset_m);
          const glm::vec3 root_m = eye_from_tile_m + glm::vec3(blade.root_m, ground.height_m);
          const float distance_m = glm::length(root_m);
          const glm::vec3 normal = kernels.normalized({-ground.slope.x, -ground.slope.y, 1.0f});
          const float keep =
              kernels.keep_share(plan.lod, kernels.inner(normal, -root_m / distance_m), pixel * distance_m,
                                 distance_m, meadow.species[cell.species].species.params.width_m) *
              kernels.crowded_share(plan.lod, kernels.mean_density_per_m2(cell));
          const float rank = (static_cast<float>(k) + cell.rank_offset) / static_cast<float>(cell.planted);
          const float growth = kernels.growth_of(plan.lod, keep * left, rank);
          if (growth <= 0.0f) continue;
          const auto curve = kernels.curve_of(
              kernels.chain_of(blade, kernels.pose_blade(blade, ground.slope, growth), growth));
          for (const float t : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
            const glm::vec3 point_m = kernels.hermite_point(curve.base_m, curve.tip_m, curve.base_tangent_m,
                                                            curve.tip_tangent_m, t);
            if (!sees(camera, eye_from_tile_m + point_m)) continue;
            ++missing;
            break;
          }
        }
      }
    }
  }
  EXPECT_EQ(missing, 0) << "blades that would show are not drawn";
  return shown;
}

Meadow small_rich_meadow() {
  Meadow meadow = rich_meadow(kExtentM);
  for (PlantedSpecies& species : meadow.species) {
    species.density_per_m2 = smooth_density(kExtentM, 15.0);
  }
  return meadow;
}

TEST(PlannerTest, EverySeenBladeIsPlanned) {
  const Meadow meadow = small_rich_meadow();
  std::mt19937 random(41);
  int shown = 0;
  for (int n = 0; n < 40; ++n) {
    const Quality quality = n % 3 == 0 ? Quality::kLow : n % 3 == 1 ? Quality::kMedium : Quality::kHigh;
    shown += expect_seen_blades_planned(meadow, random_camera(meadow, random), {Tier::kAuto, quality, 60.0});
  }
  EXPECT_GT(shown, 20000);
}

TEST(PlannerTest, EverySeenBladeIsPlannedWhereTheyGrowTall) {
  Meadow meadow = small_rich_meadow();
  meadow.blade_height = grid_from(square_frame(kExtentM, 2.0), [](glm::dvec2) { return 4.0; });
  std::mt19937 random(42);
  for (int n = 0; n < 20; ++n) {
    expect_seen_blades_planned(meadow, random_camera(meadow, random), {Tier::kAuto, Quality::kHigh, 60.0});
  }
}

TEST(PlannerTest, EverySeenBladeIsPlannedInTheHermiteTier) {
  const Meadow meadow = small_rich_meadow();
  std::mt19937 random(43);
  for (int n = 0; n < 20; ++n) {
    expect_seen_blades_planned(meadow, random_camera(meadow, random), {Tier::kHermite, Quality::kLow, 10.0});
  }
}

TEST(PlannerTest, HermiteTierDrawsAllBladesInView) {
  const Meadow meadow = rich_meadow(kExtentM);
  const Camera camera = camera_at({20.0, -5.0, 140.0}, 0.0, -0.9);
  const FramePlan plan = Planner(meadow).plan(camera, {Tier::kHermite, Quality::kLow, 1.0});
  ASSERT_FALSE(plan.cells.empty());
  for (const DrawnCell& cell : plan.cells) EXPECT_EQ(cell.drawn, cell.planted.planted);
  EXPECT_LE(plan.blades_drawn, plan.blades_planted_in_view);  // short blades of a cell may all be out of view
}

TEST(PlannerTest, FlatTierDrawsNoBlades) {
  const Meadow meadow = rich_meadow(kExtentM);
  const FramePlan plan =
      Planner(meadow).plan(camera_at({20.0, 5.0, 130.0}, 0.0, -0.5), {Tier::kFlat, Quality::kHigh, 100.0});
  EXPECT_TRUE(plan.cells.empty());
  EXPECT_TRUE(plan.groups.empty());
  EXPECT_EQ(plan.blades_drawn, 0u);
  EXPECT_FALSE(plan.ground.empty());
}

TEST(PlannerTest, GroupsHoldAllCellsOfOneSegmentCountNearestFirst) {
  const Meadow meadow = rich_meadow(kExtentM);
  Camera camera = camera_at({20.0, 1.0, 122.0}, 0.1, -0.1);
  camera.size_px = {3200, 2400};
  const FramePlan plan = Planner(meadow).plan(camera, {Tier::kAuto, Quality::kMedium, 120.0});
  ASSERT_GE(plan.groups.size(), 3u);
  std::uint32_t next = 0, segments = 1000;
  bool is_spline = true;
  std::uint64_t blades = 0;
  for (const CellGroup& group : plan.groups) {
    EXPECT_EQ(group.first_cell, next);
    EXPECT_GT(group.cell_count, 0u);
    if (is_spline == group.is_spline) {
      EXPECT_LT(group.segments, segments) << "most segments first";
    } else {
      EXPECT_FALSE(group.is_spline) << "splines first";
    }
    is_spline = group.is_spline;
    segments = group.segments;
    double previous_m = 0.0;
    for (std::uint32_t n = next; n < next + group.cell_count; ++n) {
      const DrawnCell& cell = plan.cells[n];
      EXPECT_GT(cell.drawn, 0u);
      EXPECT_LE(cell.drawn, cell.planted.planted);
      blades += cell.drawn;
      // Front to back by a box that is wider than the ground by a blade's length.
      const glm::dvec2 min_m(glm::vec2(cell.eye_from_tile_m) + cell.planted.offset_m);
      const glm::dvec2 away = glm::max(glm::max(min_m, -(min_m + 2.0)), glm::dvec2(0.0));
      EXPECT_GE(glm::length(away), previous_m - 8.0);
      previous_m = std::max(previous_m, glm::length(away));
    }
    next += group.cell_count;
  }
  EXPECT_EQ(next, plan.cells.size());
  EXPECT_EQ(blades, plan.blades_drawn);
}

Blade first_blade(Kernels kernels, const PlantedCell& cell, const SpeciesParams& species) {
  const auto root = kernels.plant_root(cell, 0);
  return kernels.plant_blade(cell, species, kernels.features_of(cell, kernels.root_in_cell(cell, root)), root,
                             0);
}

TEST(PlannerTest, CellsBringTheirTables) {
  const Meadow meadow = rich_meadow(kExtentM);
  const FramePlan plan = Planner(meadow).plan(camera_at({20.0, 1.0, 122.0}, 0.1, -0.1), {});
  const PlantingLattice lattice(meadow);
  std::map<Key, std::pair<PlantedCell, CellTables>> reference;
  for (int n = 0; n < 100; ++n) {
    for (int cell = 0; cell < kCellsPerTile; ++cell) {
      CellTables tables;
      append_cell(meadow, lattice, {n % 10, n / 10}, cell, tables);
      for (const PlantedCell& planted : tables.cells) {
        reference[{planted.key.x, planted.species}] = {planted, tables};
      }
    }
  }
  Kernels planned{plan.tables.data()};
  for (const DrawnCell& cell : plan.cells) {
    const auto& [planted, tables] = reference.at({cell.planted.key.x, cell.planted.species});
    Kernels kernels{tables.tables.data()};
    const SpeciesParams& species = meadow.species[planted.species].species.params;
    const Blade a = first_blade(kernels, planted, species);
    const Blade b = first_blade(planned, cell.planted, species);
    ASSERT_EQ(std::memcmp(&a, &b, sizeof(Blade)), 0);
  }
}

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/// What was planned before shows in nothing but the play of morphing tiles.
TEST(PlannerTest, PlansDependOnTheCameraButForTheirPlay) {
  const Meadow meadow = small_rich_meadow();
  std::mt19937 random(44);
  Planner used(meadow);
  for (int n = 0; n < 300; ++n) {
    const Camera camera = random_camera(meadow, random);
    used.plan(camera, {});
    if (n % 30 != 0) continue;
    // Tiles that are out of view for a frame forget.
    Camera away = camera;
    away.eye_m = {-500.0, -500.0, 1000.0};
    used.plan(away, {});
    const FramePlan plan = used.plan(camera, {});
    const FramePlan fresh = Planner(meadow).plan(camera, {});
    ASSERT_TRUE(same_bytes(plan.cells, fresh.cells));
    ASSERT_TRUE(same_bytes(plan.tables, fresh.tables));
    ASSERT_TRUE(same_bytes(plan.strips, fresh.strips));
    ASSERT_EQ(plan.ground.size(), fresh.ground.size());
    ASSERT_EQ(plan.blades_drawn, fresh.blades_drawn);
  }
}

std::map<std::pair<float, float>, float> morphs_by_place(const FramePlan& plan) {
  std::map<std::pair<float, float>, float> morphs;
  for (const DrawnCell& cell : plan.cells) {
    // Tiles lie on whole multiples of their side from the scene's origin.
    const glm::dvec2 tile_m = glm::dvec2(glm::vec2(cell.eye_from_tile_m)) + glm::dvec2(plan.camera.eye_m);
    morphs[{std::round(static_cast<float>(tile_m.x)), std::round(static_cast<float>(tile_m.y))}] = cell.morph;
  }
  return morphs;
}

/// An eye that trembles by a few centimetres leaves morphing tiles as they are; one that walks on carries
/// them with it.
TEST(PlannerTest, MorphsHavePlay) {
  const Meadow meadow = level_meadow(kExtentM, uniform_density(100.0));
  Planner planner(meadow);
  const auto plan_at = [&](double y) { return planner.plan(camera_at({20.0, y, 1.7}, 0.0, -0.05), {}); };
  const auto before = morphs_by_place(plan_at(1.0));
  for (const double y : {1.03, 0.97, 1.05, 0.95, 1.0}) {
    for (const auto& [place, morph] : morphs_by_place(plan_at(y))) {
      if (before.contains(place)) {
        EXPECT_FLOAT_EQ(morph, before.at(place));
      }
    }
  }
  const auto walked = morphs_by_place(plan_at(4.0));
  const auto fresh = morphs_by_place(Planner(meadow).plan(camera_at({20.0, 4.0, 1.7}, 0.0, -0.05), {}));
  int morphing = 0;
  for (const auto& [place, morph] : fresh) {
    if (morph <= 0.0f || !walked.contains(place)) continue;
    ++morphing;
    EXPECT_NEAR(walked.at(place), morph, 0.04f);
  }
  EXPECT_GT(morphing, 1);
}

/// Tiers follow the eye that they are asked to follow, the view does not.
TEST(PlannerTest, TiersAreChosenForAnotherEye) {
  const Meadow meadow = level_meadow(kExtentM, uniform_density(100.0));
  const Camera camera = camera_at({20.0, -2.0, 1.7}, 0.0, -0.05);
  PlanOptions options;
  options.lod_eye_m = glm::dvec3(20.0, -60.0, 1.7);
  const FramePlan plan = Planner(meadow).plan(camera, options);
  EXPECT_TRUE(plan.cells.empty());
  EXPECT_FALSE(plan.strips.empty());
  options.lod_eye_m = camera.eye_m;
  const FramePlan own = Planner(meadow).plan(camera, options);
  const FramePlan usual = Planner(meadow).plan(camera, {});
  EXPECT_TRUE(same_bytes(own.cells, usual.cells));
  EXPECT_TRUE(same_bytes(own.strips, usual.strips));
}

/// Every tile in view stands in 3D or in strips or in both, until it has sunk.
TEST(PlannerTest, StripsTakeOverFromBlades) {
  const Meadow meadow = level_meadow(kExtentM, uniform_density(100.0));
  const FramePlan plan = Planner(meadow).plan(camera_at({20.0, -2.0, 1.7}, 0.0, -0.05), {});
  int both = 0;
  for (const StripTile& strip : plan.strips) {
    EXPECT_GT(strip.grown, 0.0f);
    EXPECT_LE(strip.grown, 1.0f);
    for (const DrawnCell& cell : plan.cells) {
      if (cell.eye_from_tile_m != strip.eye_from_tile_m) continue;
      ++both;
      EXPECT_GT(cell.morph, 0.0f);
      EXPECT_LT(cell.morph, 1.0f);
      break;
    }
  }
  EXPECT_GE(both, 1);
  EXPECT_LT(static_cast<std::size_t>(both), plan.strips.size());
  const FramePlan steep = Planner(meadow).plan(camera_at({20.0, 20.0, 40.0}, 0.0, -1.3), {});
  EXPECT_TRUE(steep.strips.empty()) << "seen from above, thinned blades stand";
  EXPECT_FALSE(steep.cells.empty());
}

/// Walking never makes a cell of the middle distance drop many blades at once: the counts in the plan follow
/// the eye.
TEST(PlannerTest, CountsFollowTheEye) {
  const Meadow meadow = level_meadow(kExtentM, uniform_density(400.0));
  Planner planner(meadow);
  double previous = -1.0;
  for (int step = 0; step < 200; ++step) {
    Camera camera = camera_at({20.0, -30.0 + 0.05 * step, 1.7}, 0.0, -0.05);
    camera.size_px = {3200, 2400};
    const auto drawn = static_cast<double>(planner.plan(camera, {}).blades_drawn);
    if (previous >= 0.0) {
      EXPECT_NEAR(drawn / previous, 1.0, 0.02) << step;
    }
    previous = drawn;
  }
}

TEST(PlannerTest, NothingIsPlannedBeyondTheBladeDistance) {
  const Meadow meadow = level_meadow(kExtentM, uniform_density(100.0));
  const FramePlan plan =
      Planner(meadow).plan(camera_at({20.0, -100.0, 1.7}, 0.0, 0.0), {Tier::kAuto, Quality::kHigh, 90.0});
  EXPECT_TRUE(plan.cells.empty());
}

/// Where the nearest cells lie as seen from the eye: exactly the same, since they are told relative to it.
std::vector<std::pair<float, float>> near_cells(const FramePlan& plan) {
  std::vector<std::pair<float, float>> cells;
  for (const DrawnCell& cell : plan.cells) {
    const glm::vec2 corner_m = glm::vec2(cell.eye_from_tile_m) + cell.planted.offset_m;
    if (glm::length(corner_m) < 6.0f) cells.push_back({corner_m.x, corner_m.y});
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());  // quarters and species of one cell
  return cells;
}

TEST(PlannerTest, RefusesMoreCellsThanItsBudgetHolds) {
  const Meadow meadow = level_meadow(kExtentM, uniform_density(100.0));
  const Camera camera = camera_at({20.0, -5.0, 10.0}, 0.0, -0.5);
  PlanOptions options;
  options.memory_budget_bytes = 10'000;
  EXPECT_THROW(Planner(meadow).plan(camera, options), OverBudget);
  options.memory_budget_bytes = 10'000'000;
  EXPECT_FALSE(Planner(meadow).plan(camera, options).cells.empty());
}

TEST(PlannerTest, FarAwayInARepeatingWorldPlansLikeAtHome) {
  Meadow meadow = level_meadow(kExtentM, uniform_density(100.0));
  meadow.repeats = true;
  const FramePlan home = Planner(meadow).plan(camera_at({20.25, 20.5, 1.7}, 0.3, -0.1), {});
  const FramePlan away = Planner(meadow).plan(camera_at({250020.25, -399979.5, 1.7}, 0.3, -0.1), {});
  EXPECT_GT(near_cells(home).size(), 10u);
  EXPECT_EQ(near_cells(home), near_cells(away));
}

}  // namespace
}  // namespace prairie
