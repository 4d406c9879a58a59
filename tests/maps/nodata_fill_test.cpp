#include "maps/nodata_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "maps/height_field.h"
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

class NodataFill : public ::testing::TestWithParam<Gap> {};

TEST_P(NodataFill, LeavesMeasuredNodesAloneAndStaysInTheirRange) {
  std::vector<float> values = rolling_values();
  const std::vector<float> truth = values;
  for (int j = 0; j < kNodes; ++j) {
    for (int i = 0; i < kNodes; ++i) {
      if (is_gap(GetParam(), i, j)) values[static_cast<std::size_t>(j * kNodes + i)] = kNaN;
    }
  }
  std::vector<float> filled = values;
  fill_nodata(kNodes, kNodes, false, filled);
  const auto [low, high] = std::minmax_element(truth.begin(), truth.end());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isnan(values[k])) {
      EXPECT_EQ(filled[k], values[k]);
    }
    EXPECT_GE(filled[k], *low);
    EXPECT_LE(filled[k], *high);
  }
}

TEST_P(NodataFill, NoSlopeNearAGapIsSteeperThanTheSteepestThousandthOfMeasuredGround) {
  std::vector<float> values = rolling_values();
  for (int j = 0; j < kNodes; ++j) {
    for (int i = 0; i < kNodes; ++i) {
      if (is_gap(GetParam(), i, j)) values[static_cast<std::size_t>(j * kNodes + i)] = kNaN;
    }
  }
  const HeightField field(NodeGrid({kNodes, kNodes, 1.0, {0.0, 0.0}, false}, 1, std::move(values)));
  std::vector<float> measured, near_gap;
  for (double y = 0.0; y <= kNodes - 1; y += 0.5) {
    for (double x = 0.0; x <= kNodes - 1; x += 0.5) {
      const float slope = steepness(field, {x, y});
      if (field.has_data({x, y}, {x, y})) {
        measured.push_back(slope);
      } else if (field.has_data({x - 6.0, y}, {x - 3.0, y}) || field.has_data({x + 3.0, y}, {x + 6.0, y}) ||
                 GetParam() == Gap::kSpecks) {
        near_gap.push_back(slope);
      }
    }
  }
  ASSERT_FALSE(near_gap.empty());
  const auto bar =
      measured.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(measured.size()) * 0.999);
  std::nth_element(measured.begin(), bar, measured.end());
  EXPECT_LE(*std::max_element(near_gap.begin(), near_gap.end()), *bar);
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
