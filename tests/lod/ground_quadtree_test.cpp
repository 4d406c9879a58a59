// The ground's patches: they tile what is seen, nearest first, and neighbours fit together.
#include "lod/ground_quadtree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

using PatchKey = std::tuple<int, int, int>;  // level, column, row

Meadow hilly_meadow() {
  Meadow meadow = level_meadow(64.0, uniform_density(10.0));
  meadow.ground = HeightField(grid_from(square_frame(64.0, 2.0), [](glm::dvec2 p) {
    return 3.0 * std::sin(0.2 * p.x) + 2.0 * std::cos(0.3 * p.y);
  }));
  return meadow;
}

Camera random_camera(std::mt19937& random, bool parallel) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Camera camera;
  camera.eye_m = {200.0 * unit(random) - 70.0, 200.0 * unit(random) - 70.0,
                  6.0 + 200.0 * std::pow(unit(random), 4.0)};
  camera.yaw_rad = 6.2832 * unit(random);
  camera.pitch_rad = 0.3 - 1.8 * unit(random);
  if (parallel) camera.orthographic_height_m = 5.0 + 300.0 * unit(random);
  return camera;
}

class Patches {
 public:
  explicit Patches(const std::vector<GroundPatch>& patches) {
    for (const GroundPatch& patch : patches) by_key_[{patch.level, patch.column, patch.row}] = patch;
    EXPECT_EQ(by_key_.size(), patches.size()) << "a patch comes twice";
  }

  /// Levels of the patches that contain a place.
  std::vector<int> levels_at(glm::dvec2 position_m) const {
    std::vector<int> levels;
    for (int level = 0; level < 12; ++level) {
      const double side_m = patch_side_m(level);
      const PatchKey key{level, static_cast<int>(std::floor(position_m.x / side_m)),
                         static_cast<int>(std::floor(position_m.y / side_m))};
      if (by_key_.contains(key)) levels.push_back(level);
    }
    return levels;
  }

 private:
  std::map<PatchKey, GroundPatch> by_key_;
};

bool sees(const Camera& camera, glm::dvec3 point_m) {
  const glm::vec4 clip = camera.clip_from_eye() * glm::vec4(glm::vec3(point_m - camera.eye_m), 1.0f);
  return clip.w > 0.0f && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w && clip.z < clip.w;
}

void expect_tiling(bool parallel) {
  const Meadow meadow = hilly_meadow();
  std::mt19937 random(31);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int seen = 0;
  for (int n = 0; n < 60; ++n) {
    const Camera camera = random_camera(random, parallel);
    constexpr double kFarM = 1000.0;
    const Patches patches(ground_patches(meadow, camera, kFarM));
    for (int place = 0; place < 2000; ++place) {
      const double turn = 6.2832 * unit(random);
      const double away_m = 0.7 * kFarM * std::pow(unit(random), 3.0);
      const glm::dvec2 p = glm::dvec2(camera.eye_m) + away_m * glm::dvec2(std::cos(turn), std::sin(turn));
      const std::vector<int> levels = patches.levels_at(p);
      ASSERT_LE(levels.size(), 1u) << "patches overlap";
      if (!sees(camera, {p.x, p.y, static_cast<double>(meadow.ground.height_m(p))})) continue;
      ++seen;
      ASSERT_EQ(levels.size(), 1u) << "a hole in the ground at " << p.x << ", " << p.y;
    }
  }
  EXPECT_GT(seen, 5000);
}

TEST(GroundQuadtreeTest, PatchesTileWhatIsSeen) {
  expect_tiling(false);
}
TEST(GroundQuadtreeTest, PatchesTileWhatAParallelProjectionSees) {
  expect_tiling(true);
}

/// Along each side, just outside: the neighbour there is at most one level coarser or finer, and
/// `coarser_sides` says which.
TEST(GroundQuadtreeTest, NeighboursDifferByOneLevelAtMostAndSidesKnow) {
  const Meadow meadow = hilly_meadow();
  std::mt19937 random(32);
  int coarser = 0, equal = 0, finer = 0;
  for (int n = 0; n < 60; ++n) {
    const Camera camera = random_camera(random, n % 4 == 0);
    const std::vector<GroundPatch> found = ground_patches(meadow, camera, 1000.0);
    const Patches patches(found);
    for (const GroundPatch& patch : found) {
      const double side_m = patch_side_m(patch.level);
      const glm::dvec2 corner_m = side_m * glm::dvec2(patch.column, patch.row);
      const std::pair<PatchSide, glm::dvec2> sides[] = {
          {kWest, {-1, 0}}, {kEast, {1, 0}}, {kSouth, {0, -1}}, {kNorth, {0, 1}}};
      for (const auto& [side, direction] : sides) {
        for (const double along : {-0.25, 0.25}) {
          const glm::dvec2 middle_m = corner_m + 0.5 * side_m;
          const glm::dvec2 tangent(direction.y, direction.x);
          const glm::dvec2 beyond_m = middle_m + (0.5 * side_m + 0.1) * direction + along * side_m * tangent;
          const std::vector<int> levels = patches.levels_at(beyond_m);
          if (levels.empty()) continue;
          ASSERT_LE(std::abs(levels[0] - patch.level), 1);
          ASSERT_EQ((patch.coarser_sides & side) != 0, levels[0] > patch.level);
          (levels[0] > patch.level ? coarser : levels[0] == patch.level ? equal : finer) += 1;
        }
      }
    }
  }
  EXPECT_GT(coarser, 500);
  EXPECT_GT(equal, 500);
  EXPECT_GT(finer, 500);
}

TEST(GroundQuadtreeTest, NearestComeFirst) {
  const Meadow meadow = level_meadow(64.0, uniform_density(10.0));
  std::mt19937 random(33);
  for (int n = 0; n < 30; ++n) {
    const Camera camera = random_camera(random, false);
    double previous_m = 0.0;
    for (const GroundPatch& patch : ground_patches(meadow, camera, 1000.0)) {
      const double side_m = patch_side_m(patch.level);
      const glm::dvec2 min_m = side_m * glm::dvec2(patch.column, patch.row);
      const double distance_m = nearest_distance_m({{min_m, 0.0}, {min_m + side_m, 0.0}}, camera.eye_m);
      ASSERT_GE(distance_m, previous_m - 1e-5);
      previous_m = distance_m;
    }
  }
}

TEST(GroundQuadtreeTest, PatchesAreFinestAtTheEye) {
  const Meadow meadow = level_meadow(64.0, uniform_density(10.0));
  Camera camera;
  camera.eye_m = {30.0, 30.0, 1.7};
  camera.pitch_rad = -0.5;
  const std::vector<GroundPatch> patches = ground_patches(meadow, camera, 5000.0);
  ASSERT_FALSE(patches.empty());
  EXPECT_EQ(patches.front().level, 0);
  EXPECT_LT(patches.size(), 400u);
}

}  // namespace
}  // namespace prairie
