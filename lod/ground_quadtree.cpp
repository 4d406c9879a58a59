#include "lod/ground_quadtree.h"

#include <algorithm>
#include <cmath>

namespace prairie {
namespace {

// A patch is split while the eye is nearer than this many of its sides. From 1 upwards neighbours differ by
// at most one level: a patch that stays whole lies at least a side away, and half a side further nothing is
// split twice.
constexpr double kSplitSides = 1.0;
// A quad of a parallel projection is at most this many pixels wide.
constexpr double kParallelQuadPixels = 4.0;

class Quadtree {
 public:
  Quadtree(const Meadow& meadow, const Camera& camera, double far_m)
      : meadow_(meadow), camera_(camera), frustum_(camera), far_m_(far_m) {}

  std::vector<GroundPatch> patches() {
    int level = 0;
    while (patch_side_m(level) < far_m_) ++level;
    const double side_m = patch_side_m(level);
    const int column = static_cast<int>(std::floor(camera_.eye_m.x / side_m));
    const int row = static_cast<int>(std::floor(camera_.eye_m.y / side_m));
    for (int y = row - 1; y <= row + 1; ++y) {
      for (int x = column - 1; x <= column + 1; ++x) visit({level, x, y, 0});
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Found& a, const Found& b) { return a.distance_m < b.distance_m; });
    std::vector<GroundPatch> patches;
    patches.reserve(found_.size());
    for (const Found& found : found_) patches.push_back(found.patch);
    return patches;
  }

 private:
  struct Found {
    GroundPatch patch;
    double distance_m;
  };

  // Splitting depends on the horizontal distance alone, so that every patch can tell its neighbours' levels.
  static double horizontal_distance_m(const GroundPatch& patch, glm::dvec3 eye_m) {
    const double side_m = patch_side_m(patch.level);
    const double west_m = patch.column * side_m;
    const double south_m = patch.row * side_m;
    const double x = std::max({west_m - eye_m.x, 0.0, eye_m.x - west_m - side_m});
    const double y = std::max({south_m - eye_m.y, 0.0, eye_m.y - south_m - side_m});
    return std::hypot(x, y);
  }

  bool is_split(const GroundPatch& patch) const {
    if (patch.level == 0) return false;
    const double side_m = patch_side_m(patch.level);
    if (camera_.is_orthographic()) return side_m / kPatchQuads > kParallelQuadPixels * camera_.pixel_m();
    const double distance_m = std::hypot(horizontal_distance_m(patch, camera_.eye_m), height_above_m());
    return distance_m < kSplitSides * side_m;
  }

  double height_above_m() const {
    const HeightRange range = meadow_.ground.range();
    return std::max(0.0, camera_.eye_m.z - static_cast<double>(range.max_m));
  }

  void visit(const GroundPatch& patch) {
    const double side_m = patch_side_m(patch.level);
    const glm::dvec2 min_m = side_m * glm::dvec2(patch.column, patch.row);
    const HeightRange range = meadow_.ground.range(min_m, min_m + side_m);
    const AlignedBox box{glm::dvec3(min_m, range.min_m), glm::dvec3(min_m + side_m, range.max_m)};
    if (!frustum_.may_see(box)) return;
    const double distance_m = nearest_distance_m(box, camera_.eye_m);
    if (distance_m > far_m_) return;
    if (!is_split(patch)) {
      found_.push_back({with_sides(patch), distance_m});
      return;
    }
    for (int child = 0; child < 4; ++child) {
      visit({patch.level - 1, 2 * patch.column + child % 2, 2 * patch.row + child / 2, 0});
    }
  }

  // A neighbour is coarser if it is not there at this level: its parent was not split.
  GroundPatch with_sides(GroundPatch patch) const {
    const auto coarser = [&](int dx, int dy) {
      const GroundPatch neighbour{patch.level, patch.column + dx, patch.row + dy, 0};
      return !is_split({neighbour.level + 1, neighbour.column >> 1, neighbour.row >> 1, 0});
    };
    std::uint8_t sides = 0;
    if (coarser(-1, 0)) sides |= kWest;
    if (coarser(1, 0)) sides |= kEast;
    if (coarser(0, -1)) sides |= kSouth;
    if (coarser(0, 1)) sides |= kNorth;
    patch.coarser_sides = sides;
    return patch;
  }

  const Meadow& meadow_;
  const Camera& camera_;
  Frustum frustum_;
  double far_m_;
  std::vector<Found> found_;
};

}  // namespace

double patch_side_m(int level) {
  return std::ldexp(kFinestQuadM * kPatchQuads, level);
}

std::vector<GroundPatch> ground_patches(const Meadow& meadow, const Camera& camera, double far_m) {
  return Quadtree(meadow, camera, far_m).patches();
}

}  // namespace prairie
