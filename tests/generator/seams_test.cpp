// Borders of tiles and cells do not show: as many blades stand along them as elsewhere, at the same
// distances.
//
// Uniform density, so that every difference is a seam. The cells' sequences are independent, so that across a
// border two blades can come closer than inside a cell; how much is stated by the second test.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "generator/plant.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr double kDensityPerM2 = 400.0;
constexpr double kExtentM = 80.0;
constexpr double kCellM = 2.0;

std::vector<glm::dvec2> roots_of_field(std::uint64_t seed) {
  Meadow meadow = level_meadow(kExtentM, uniform_density(kDensityPerM2));
  meadow.seed = seed;
  std::vector<glm::dvec2> roots_m;
  for (int j = 0; j < 20; ++j) {
    for (int i = 0; i < 20; ++i) {
      for (const Blade& blade : plant_tile(meadow, {i, j})) {
        roots_m.push_back(tile_origin_m(meadow, {i, j}) + glm::dvec2(blade.root_m));
      }
    }
  }
  return roots_m;
}

/// Bands 5 cm wide, by where in a cell they lie; those in the middle of the list straddle borders. 40 bands
/// of 80 m at 400/m² over 4 seeds hold 256 000 blades; thrown at random their number would have a standard
/// deviation of 0.2 %.
TEST(SeamsTest, BandsAcrossBordersHoldAsManyBlades) {
  constexpr int kBands = 40;
  for (const int axis : {0, 1}) {
    std::array<double, kBands> counts{};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      for (const glm::dvec2 root_m : roots_of_field(seed)) {
        const double along_m = std::fmod(root_m[axis] + 0.5 * kCellM / kBands, kCellM);
        ++counts[static_cast<std::size_t>(std::min(kBands - 1, static_cast<int>(along_m / kCellM * kBands)))];
      }
    }
    const double expected = 4.0 * kDensityPerM2 * kExtentM * kExtentM / kBands;
    std::printf("axis %d: bands across borders %+.3f %%\n", axis, 100.0 * (counts[0] / expected - 1.0));
    for (int band = 0; band < kBands; ++band) {
      EXPECT_NEAR(counts[static_cast<std::size_t>(band)] / expected, 1.0, 0.01)
          << "axis " << axis << ", band " << band;
    }
  }
}

class NearestRoots {
 public:
  explicit NearestRoots(const std::vector<glm::dvec2>& roots_m) : roots_m_(roots_m), buckets_(kSide * kSide) {
    for (std::size_t n = 0; n < roots_m.size(); ++n) buckets_[bucket_of(roots_m[n])].push_back(n);
  }

  double distance_m(std::size_t root) const {
    const glm::dvec2 p = roots_m_[root];
    const int column = static_cast<int>(p.x / kBucketM);
    const int row = static_cast<int>(p.y / kBucketM);
    double nearest_m = 1e9;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, kSide - 1); ++y) {
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, kSide - 1); ++x) {
        for (const std::size_t n : buckets_[static_cast<std::size_t>(y * kSide + x)]) {
          if (n != root)
            nearest_m = std::min(nearest_m, std::hypot(roots_m_[n].x - p.x, roots_m_[n].y - p.y));
        }
      }
    }
    return nearest_m;
  }

 private:
  static constexpr double kBucketM = 0.2;
  static constexpr int kSide = 401;
  static std::size_t bucket_of(glm::dvec2 p) {
    return static_cast<std::size_t>(static_cast<int>(p.y / kBucketM) * kSide +
                                    static_cast<int>(p.x / kBucketM));
  }
  const std::vector<glm::dvec2>& roots_m_;
  std::vector<std::vector<std::size_t>> buckets_;
};

/// Distance to the nearest neighbour, on average over blades near a border and over those far from any. For
/// blades at random it is 0.5/√density; a sequence is somewhat more even than that inside, at random across.
/// 10 % is what the two differ by at most if borders neither crowd nor part the blades.
TEST(SeamsTest, NeighboursAcrossBordersStandAsFarApart) {
  const std::vector<glm::dvec2> roots_m = roots_of_field(9);
  const NearestRoots nearest(roots_m);
  double near_sum = 0.0, near_count = 0.0, far_sum = 0.0, far_count = 0.0;
  for (std::size_t n = 0; n < roots_m.size(); ++n) {
    const glm::dvec2 p = roots_m[n];
    if (p.x < 1.0 || p.y < 1.0 || p.x > kExtentM - 1.0 || p.y > kExtentM - 1.0) continue;
    const auto to_border_m = [](double x) { return std::abs(x - kCellM * std::round(x / kCellM)); };
    const double border_m = std::min(to_border_m(p.x), to_border_m(p.y));
    if (border_m < 0.02) near_sum += nearest.distance_m(n), near_count += 1.0;
    if (border_m > 0.2) far_sum += nearest.distance_m(n), far_count += 1.0;
  }
  const double at_random_m = 0.5 / std::sqrt(kDensityPerM2);
  const double near_m = near_sum / near_count;
  const double far_m = far_sum / far_count;
  std::printf("nearest neighbour: %.3f at borders, %.3f inside (1 = at random)\n", near_m / at_random_m,
              far_m / at_random_m);
  EXPECT_GT(near_count, 10000.0);
  EXPECT_NEAR(near_m / far_m, 1.0, 0.1);
}

}  // namespace
}  // namespace prairie
