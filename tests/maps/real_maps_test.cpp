// Public lidar tiles, where PRAIRIE_DATA names the folder that holds them; half of one has no data.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "maps/height_field.h"
#include "maps/map_file.h"

namespace prairie {
namespace {

constexpr std::uint64_t kBudget = std::uint64_t{1} << 28;

class RealMaps : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("PRAIRIE_DATA");
    if (folder == nullptr) GTEST_SKIP() << "PRAIRIE_DATA is not set to the folder of real maps";
    folder_ = folder;
    konza_ = folder_ / "konza_neon_1m/NEON_D06_KONZ_DP3_702000_4333000_DTM.tif";
    if (!std::filesystem::exists(konza_)) GTEST_SKIP() << "PRAIRIE_DATA holds no konza_neon_1m";
  }
  MapSpec spec(const std::filesystem::path& file) const {
    MapSpec result;
    result.file = file;
    result.field = "heights.file";
    return result;
  }
  std::filesystem::path folder_;
  std::filesystem::path konza_;
};

TEST_F(RealMaps, KonzaLiesWhereItShould) {
  const Map map = read_map(spec(konza_), MapMeaning::kHeight, kBudget);
  EXPECT_EQ(map.grid.frame().columns, 1000);
  EXPECT_EQ(map.grid.frame().spacing_m, 1.0);
  ASSERT_TRUE(map.geo_reference.has_value());
  EXPECT_EQ(map.geo_reference->west_m, 702000.5);
  EXPECT_EQ(map.geo_reference->south_m, 4333000.5);
  ASSERT_EQ(map.warnings.size(), 1u);
  EXPECT_NE(map.warnings[0].text.find("46.9 % of the nodes have no data"), std::string::npos)
      << map.warnings[0].text;
  const HeightField ground(map.grid);
  EXPECT_NEAR(ground.range().min_m, 309.6f, 0.1f);
  EXPECT_NEAR(ground.range().max_m, 367.7f, 0.1f);
}

TEST_F(RealMaps, KonzaHasNoCliffsAroundItsGap) {
  const Map map = read_map(spec(konza_), MapMeaning::kHeight, kBudget);
  const HeightField ground(map.grid);
  const std::span<const float> nodes = map.grid.values();
  constexpr int kSide = 1000;
  constexpr int kReach = 4;  // nodes; covers 3 m around a missing node

  // Nodes within reach of both measured and missing ones.
  std::vector<int> missing_before(kSide * (kSide + 1), 0);
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const std::size_t k = static_cast<std::size_t>(j * (kSide + 1) + i);
      missing_before[k + 1] =
          missing_before[k] + (std::isnan(nodes[static_cast<std::size_t>(j * kSide + i)]) ? 1 : 0);
    }
  }
  const auto near_edge = [&](int i, int j) {
    int missing = 0, all = 0;
    const int low = std::max(0, i - kReach), high = std::min(kSide - 1, i + kReach);
    for (int y = std::max(0, j - kReach); y <= std::min(kSide - 1, j + kReach); ++y) {
      const std::size_t row = static_cast<std::size_t>(y * (kSide + 1));
      missing += missing_before[row + static_cast<std::size_t>(high) + 1] -
                 missing_before[row + static_cast<std::size_t>(low)];
      all += high - low + 1;
    }
    return missing > 0 && missing < all;
  };

  std::vector<float> measured;
  float steepest_near_gap = 0.0f;
  for (int row = 0; row < 2 * kSide - 1; ++row) {
    for (int column = 0; column < 2 * kSide - 1; ++column) {
      const glm::dvec2 position_m(0.5 * column, 0.5 * row);
      const bool has_data = ground.has_data(position_m, position_m);
      const bool near_gap = near_edge(column / 2, row / 2);
      if (!has_data && !near_gap) continue;
      const glm::vec2 slope = ground.slope(position_m);
      const float steepness = std::hypot(slope.x, slope.y);
      if (has_data) measured.push_back(steepness);
      if (near_gap) steepest_near_gap = std::max(steepest_near_gap, steepness);
    }
  }
  const auto bar =
      measured.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(measured.size()) * 0.999);
  std::nth_element(measured.begin(), bar, measured.end());
  EXPECT_GT(steepest_near_gap, 0.0f);
  EXPECT_LE(steepest_near_gap, *bar);
}

TEST_F(RealMaps, NdviBecomesDensity) {
  MapSpec ndvi = spec(folder_ / "konza_neon_1m/NEON_D06_KONZ_DP3_702000_4333000_NDVI.tif");
  ndvi.range = {{0.2, 0.9}};
  ndvi.max = 2000.0;
  const Map map = read_map(ndvi, MapMeaning::kDensity, kBudget);
  std::size_t gaps = 0;
  for (const float density : map.grid.values()) {
    if (std::isnan(density)) {
      ++gaps;
    } else {
      EXPECT_TRUE(density >= 0.0f && density <= 2000.0f);
    }
  }
  EXPECT_NEAR(static_cast<double>(gaps) / 1e6, 0.516, 0.002);
}

TEST_F(RealMaps, FourMetreTileWithHugeNodata) {
  const Map map = read_map(spec(folder_ / "sjer_neon_4m/sjer_dtmcrop.tif"), MapMeaning::kHeight, kBudget);
  EXPECT_EQ(map.grid.frame().spacing_m, 4.0);
  EXPECT_TRUE(map.warnings.empty());
}

}  // namespace
}  // namespace prairie
