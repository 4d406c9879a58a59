#include "maps/nodata_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "maps/filled_heights.h"
#include "maps/height_field.h"
#include "maps/node_mask.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr int kNodes = 300;

enum class Gap { kWestHalf, kDisc, kSpecks, kRaggedEdge };

bool is_gap(Gap gap, int i, int j) {
  switch (gap) {
    case Gap::kWestHalf:
      return i < kNodes / 2;
    case Gap::kDisc:
      return std::hypot(i - 150, j - 150) < 50.0;
    case Gap::kSpecks:
      return (i * 7919 + j * 104729) % 31 == 0;
    case Gap::kRaggedEdge:
      return i < 150 + 12.0 * std::sin(j * 0.15) + 5.0 * std::sin(j * 0.61);
  }
  return false;
}

std::vector<float> rolling_values() {
  std::vector<float> values;
  for (int j = 0; j < kNodes; ++j) {
    for (int i = 0; i < kNodes; ++i) values.push_back(testing::rolling_height_m(i, j));
  }
  return values;
}

float steepness(const HeightField& field, glm::dvec2 position_m) {
  const glm::vec2 slope = field.slope(position_m);
  return std::hypot(slope.x, slope.y);
}

NodeGrid grid_of(std::vector<float> values) {
  return NodeGrid({kNodes, kNodes, 1.0, {0.0, 0.0}, false}, 1, std::move(values));
}

std::vector<float> with_gap(std::vector<float> values, Gap gap) {
  for (int j = 0; j < kNodes; ++j) {
    for (int i = 0; i < kNodes; ++i) {
      if (is_gap(gap, i, j)) values[static_cast<std::size_t>(j * kNodes + i)] = kNaN;
    }
  }
  return values;
}

/// Within 3 m of a measured and of a missing node.
bool near_gap(Gap gap, double x, double y) {
  bool missing = false, present = false;
  for (int j = std::max(0, static_cast<int>(y) - 3); j <= std::min(kNodes - 1, static_cast<int>(y) + 4);
       ++j) {
    for (int i = std::max(0, static_cast<int>(x) - 3); i <= std::min(kNodes - 1, static_cast<int>(x) + 4);
         ++i) {
      if (std::hypot(i - x, j - y) > 3.0) continue;
      (is_gap(gap, i, j) ? missing : present) = true;
    }
  }
  return missing && present;
}

float steepest_around(const HeightField& field, glm::dvec2 position_m) {
  float steepest = 0.0f;
  for (const double dx : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    for (const double dy : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      steepest = std::max(steepest, steepness(field, position_m + glm::dvec2(dx, dy)));
    }
  }
  return steepest;
}

class NodataFill : public ::testing::TestWithParam<Gap> {};

TEST_P(NodataFill, LeavesMeasuredNodesAloneAndStaysNearTheirRange) {
  const std::vector<float> values = with_gap(rolling_values(), GetParam());
  std::vector<float> filled = values;
  fill_nodata(kNodes, kNodes, false, filled);
  const std::vector<float> truth = rolling_values();
  const auto [low, high] = std::minmax_element(truth.begin(), truth.end());
  const float relief_m = *high - *low;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isnan(values[k])) {
      EXPECT_EQ(filled[k], values[k]);
    }
    EXPECT_GE(filled[k], *low - relief_m);
    EXPECT_LE(filled[k], *high + relief_m);
  }
}

TEST_P(NodataFill, RunsOnAsThePlaneDoes) {
  std::vector<float> plane;
  for (int j = 0; j < kNodes; ++j) {
    for (int i = 0; i < kNodes; ++i)
      plane.push_back(0.1f * static_cast<float>(i) + 0.07f * static_cast<float>(j));
  }
  const HeightField field(grid_of(with_gap(plane, GetParam())));
  // Nearly: the means of half-filled cells lie beside the cells' middles. A membrane would reach 4 times the
  // slope.
  const float slope = std::hypot(0.1f, 0.07f);
  for (double y = 1.0; y <= kNodes - 2; y += 0.5) {
    for (double x = 1.0; x <= kNodes - 2; x += 0.5) EXPECT_LE(steepness(field, {x, y}), 1.35f * slope);
  }
}

TEST_P(NodataFill, NoSlopeNearAGapIsSteeperThanTheSteepestThousandthOfMeasuredGround) {
  const HeightField truth(grid_of(rolling_values()));
  const HeightField field(grid_of(with_gap(rolling_values(), GetParam())));
  std::vector<float> measured;
  for (double y = 0.0; y <= kNodes - 1; y += 0.5) {
    for (double x = 0.0; x <= kNodes - 1; x += 0.5) {
      if (field.has_data({x, y}, {x, y})) measured.push_back(steepness(field, {x, y}));
    }
  }
  const auto bar =
      measured.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(measured.size()) * 0.999);
  std::nth_element(measured.begin(), bar, measured.end());
  for (double y = 0.0; y <= kNodes - 1; y += 0.5) {
    for (double x = 0.0; x <= kNodes - 1; x += 0.5) {
      if (!near_gap(GetParam(), x, y)) continue;
      // Where the ground itself is among the steepest, its last measured nodes are too.
      const float limit = std::max(*bar, steepest_around(truth, {x, y}));
      EXPECT_LE(steepness(field, {x, y}), 1.05f * limit) << x << ", " << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gaps, NodataFill,
                         ::testing::Values(Gap::kWestHalf, Gap::kDisc, Gap::kSpecks, Gap::kRaggedEdge));

TEST(NodataFillRepeating, OppositeBordersAreNeighbours) {
  constexpr int kColumns = 64;
  std::vector<float> values(kColumns * kColumns, kNaN);
  // A measured strip down the middle, higher on its east side: the gap runs around the border.
  for (std::size_t j = 0; j < kColumns; ++j) {
    for (std::size_t i = 24; i < 40; ++i) values[j * kColumns + i] = static_cast<float>(i);
  }
  fill_nodata(kColumns, kColumns, true, values);
  EXPECT_NEAR(values[0], values[kColumns - 1], 1.0f);
}

/// Wider than a page (maps/filled_heights.cpp), with a gap across its edge and one at the map's end.
TEST(NodataFillPages, GiveTheSameBitsAsTheWhole) {
  constexpr int kColumns = 2600, kRows = 310;
  std::vector<float> values;
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const bool is_missing =
          std::hypot(i - 2050, j - 150) < 90.0 || i > 2500 + j / 7 || (i * 7919 + j * 104729) % 997 == 0;
      values.push_back(is_missing ? kNaN : testing::rolling_height_m(i, j));
    }
  }
  std::vector<float> whole = values;
  fill_nodata(kColumns, kRows, false, whole);
  const NodeMask gaps(kColumns, kRows, values);
  fill_page_by_page({.columns = kColumns, .rows = kRows}, gaps, values);
  EXPECT_EQ(values, whole);
}

TEST(NodataFillSpeed, HalfOfAMillionNodesTakesLessThanASecond) {
  constexpr int kSide = 1000;
  std::vector<float> values(kSide * kSide);
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      values[static_cast<std::size_t>(j * kSide + i)] =
          i < kSide / 2 ? kNaN : static_cast<float>((i * j) % 17);
    }
  }
  const auto start = std::chrono::steady_clock::now();
  fill_nodata(kSide, kSide, false, values);
  const std::chrono::duration<double> elapsed_s = std::chrono::steady_clock::now() - start;
  EXPECT_LT(elapsed_s.count(), 1.0);
}

}  // namespace
}  // namespace prairie
