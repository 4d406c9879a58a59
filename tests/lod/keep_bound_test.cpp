// The plan draws a prefix of each cell, as long as the bound on the keep share over the cell says: no blade
// that the kernel would grow may lie beyond it. Random cells of sloped and curved ground, random eyes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "lod/thinning.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr float kWidthM = 0.004f;

constexpr double kCellM = 2.0;
constexpr int kScenes = 20000;
constexpr int kRoots = 60;

struct Scene {
  std::array<float, 9> heights_m;
  AlignedBox box;
  Camera camera;
  CellView view() const { return {box, heights_m, kCellM}; }
};

/// Ground with slopes up to `steepness`, bent by up to `curvature_m` at each of its 3 × 3 heights; eyes up to
/// 60 m away.
Scene random_scene(std::mt19937& random, double steepness, double curvature_m) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Scene scene;
  const double east = steepness * unit(random);
  const double north = steepness * unit(random);
  for (int n = 0; n < 9; ++n) {
    scene.heights_m[static_cast<std::size_t>(n)] =
        static_cast<float>(east * (n % 3) + north * (n / 3) + curvature_m * unit(random));
  }
  const HeightRange range = ground_range(scene.heights_m);
  scene.box = {{0.0, 0.0, static_cast<double>(range.min_m)},
               {kCellM, kCellM, static_cast<double>(range.max_m)}};
  const double distance_m = 60.0 * std::pow(0.5 * (unit(random) + 1.0), 2.0);
  const double turn = 3.14159 * unit(random);
  const double above_m = 0.2 + 30.0 * std::pow(0.5 * (unit(random) + 1.0), 3.0);
  scene.camera.eye_m = {1.0 + distance_m * std::cos(turn), 1.0 + distance_m * std::sin(turn),
                        scene.box.max_m.z + above_m};
  return scene;
}

/// As shaders/pass/pose.comp has it for a root at `local_m`.
double keep_of_root(const LodCoefficients& lod, const Scene& scene, glm::vec2 local_m) {
  const auto& h = scene.heights_m;
  const std::array<float, 12> table{h[0], h[1], h[2], 0.0f, h[3], h[4], h[5], 0.0f, h[6], h[7], h[8], 0.0f};
  Kernels kernels{table.data()};
  const auto ground = kernels.ground_in_cell(0u, static_cast<float>(kCellM), local_m);
  const glm::vec3 root_m(glm::dvec3(glm::dvec2(local_m), static_cast<double>(ground.height_m)) -
                         scene.camera.eye_m);
  const float distance_m = glm::length(root_m);
  const bool parallel = scene.camera.is_orthographic();
  const glm::vec3 to_eye = parallel ? glm::vec3(-scene.camera.forward()) : -root_m / distance_m;
  const glm::vec3 normal = kernels.normalized({-ground.slope.x, -ground.slope.y, 1.0f});
  const auto pixel_m = static_cast<float>(scene.camera.pixel_m());
  return static_cast<double>(kernels.keep_share(
      lod, kernels.inner(normal, to_eye), parallel ? pixel_m : pixel_m * distance_m, distance_m, kWidthM));
}

struct Outcome {
  int violated = 0;    // scenes in which a root keeps more than the bound
  double worst = 0.0;  // largest keep over bound, less one
  double slack = 0.0;  // mean of min(bound, 1) less the largest min(keep, 1)
};

Outcome outcome_for(double steepness, double curvature_m, bool parallel) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(0.0f, static_cast<float>(kCellM));
  LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  if (parallel) lod.fade_start_m = 1e9f, lod.fade_end_m = 2e9f;
  Outcome outcome;
  for (int n = 0; n < kScenes; ++n) {
    Scene scene = random_scene(random, steepness, curvature_m);
    if (parallel) {
      scene.camera.orthographic_height_m = 20.0;
      scene.camera.yaw_rad = static_cast<double>(place(random)) * 3.0;
      scene.camera.pitch_rad = -0.75 * static_cast<double>(place(random));
    }
    const double bound = keep_bound(lod, scene.camera, scene.view(), kWidthM);
    double largest = 0.0;
    for (int root = 0; root < kRoots; ++root) {
      largest = std::max(largest, keep_of_root(lod, scene, {place(random), place(random)}));
    }
    for (const float x : {0.0f, 1.0f, 2.0f}) {
      for (const float y : {0.0f, 1.0f, 2.0f}) largest = std::max(largest, keep_of_root(lod, scene, {x, y}));
    }
    // A bound of one already draws the whole cell, fully grown or not.
    if (largest > bound && bound < 1.0) {
      ++outcome.violated;
      outcome.worst = std::max(outcome.worst, largest / bound - 1.0);
    }
    outcome.slack += (std::min(bound, 1.0) - std::min(largest, 1.0)) / kScenes;
  }
  return outcome;
}

void expect_bound(const char* name, double steepness, double curvature_m, bool parallel) {
  const Outcome outcome = outcome_for(steepness, curvature_m, parallel);
  std::printf("%-20s %d of %d violated, by up to %.2f %%; %.3f of the blades drawn in vain\n", name,
              outcome.violated, kScenes, 100.0 * outcome.worst, outcome.slack);
  EXPECT_EQ(outcome.violated, 0) << name;
}

TEST(KeepBoundTest, HoldsOnLevelGround) {
  expect_bound("level", 0.0, 0.0, false);
}
TEST(KeepBoundTest, HoldsOnSlopes) {
  expect_bound("slopes", 0.7, 0.0, false);
}
TEST(KeepBoundTest, HoldsOnRollingGround) {
  expect_bound("rolling", 0.3, 0.05, false);
}
TEST(KeepBoundTest, HoldsOnRoughGround) {
  expect_bound("rough", 0.7, 0.5, false);
}
TEST(KeepBoundTest, HoldsInParallelProjections) {
  expect_bound("rough, parallel", 0.5, 0.3, true);
}

/// A blade that is drawn nowhere else has not grown.
TEST(DrawnBoundTest, LeavesOutOnlyBladesThatHaveNotGrown) {
  const LodCoefficients lod = tier_coefficients(Tier::kAuto, Quality::kMedium, 120.0, Camera{});
  std::mt19937 random(8);
  std::uniform_real_distribution<float> unit(0.001f, 0.999f);
  for (int n = 0; n < 20000; ++n) {
    PlantedCell cell{};
    cell.planted = 1 + static_cast<std::uint32_t>(3000.0f * unit(random) * unit(random));
    cell.rank_offset = unit(random);
    const float keep = 1.3f * unit(random);
    const std::uint32_t drawn = drawn_bound(cell, static_cast<double>(keep) * 1.0001);
    ASSERT_LE(drawn, cell.planted);
    for (std::uint32_t k = drawn; k < std::min(drawn + 3, cell.planted); ++k) {
      const float rank = (static_cast<float>(k) + cell.rank_offset) / static_cast<float>(cell.planted);
      ASSERT_EQ(Kernels{}.growth_of(lod, keep, rank), 0.0f) << k << " of " << cell.planted;
    }
  }
}

TEST(DrawnBoundTest, IsExpectedToBeTheShare) {
  // Over cells, ξ rounds the number drawn at random: rare species thin like common ones.
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(0.001f, 0.999f);
  double drawn = 0.0;
  constexpr int kCells = 100000;
  for (int n = 0; n < kCells; ++n) {
    PlantedCell cell{};
    cell.planted = 1;
    cell.rank_offset = unit(random);
    drawn += drawn_bound(cell, 0.3);
  }
  EXPECT_NEAR(drawn / kCells, 0.3, 0.006);
}

}  // namespace
}  // namespace prairie
