#include "maps/height_field.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "files/error.h"
#include "tests/maps/test_images.h"

namespace prairie {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

NodeGrid rolling_grid(int columns, int rows, double spacing_m, bool repeats = false) {
  std::vector<float> values;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i)
      values.push_back(testing::rolling_height_m(i * spacing_m, j * spacing_m));
  }
  return NodeGrid({columns, rows, spacing_m, {100.0, 200.0}, repeats}, 1, std::move(values));
}

/// The textbook form of the spline: a cubic Hermite with central differences as tangents.
double hermite(const std::array<double, 4>& p, double t) {
  const double m0 = 0.5 * (p[2] - p[0]), m1 = 0.5 * (p[3] - p[1]);
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * p[1] + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * p[2] + (t3 - t2) * m1;
}

double oracle(const NodeGrid& grid, double u, double v) {
  const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
  std::array<double, 4> rows{};
  for (int y = 0; y < 4; ++y) {
    std::array<float, 4> block{};
    grid.read_block({i - 1, j - 1 + y, 4, 1}, block);
    std::array<double, 4> nodes{};
    for (std::size_t k = 0; k < 4; ++k) nodes[k] = static_cast<double>(block[k]);
    rows[static_cast<std::size_t>(y)] = hermite(nodes, u - i);
  }
  return hermite(rows, v - j);
}

TEST(HeightField, IsBicubicBetweenNodes) {
  for (const bool repeats : {false, true}) {
    const NodeGrid grid = rolling_grid(23, 17, 2.0, repeats);
    const HeightField field(grid);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(0.0, 21.999), y(0.0, 15.999);
    for (int k = 0; k < 1000; ++k) {
      const double u = x(random), v = y(random);
      const double height_m = static_cast<double>(field.height_m({100.0 + 2.0 * u, 200.0 + 2.0 * v}));
      EXPECT_NEAR(height_m, oracle(grid, u, v), 1e-4);
    }
  }
}

TEST(HeightField, PassesThroughItsNodes) {
  const NodeGrid grid = rolling_grid(9, 8, 1.0);
  const HeightField field(grid);
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 9; ++i) {
      EXPECT_EQ(field.height_m({100.0 + i, 200.0 + j}), grid.values()[static_cast<std::size_t>(j * 9 + i)]);
    }
  }
}

TEST(HeightField, SlopeIsTheDerivativeAndContinuous) {
  const HeightField field(rolling_grid(40, 40, 1.0));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> along(1.0, 38.0);
  std::uniform_int_distribution<int> node(1, 37);
  for (int k = 0; k < 500; ++k) {
    // Across a line of nodes, where the patches meet.
    const glm::dvec2 p(100.0 + node(random), 200.0 + along(random));
    constexpr double kStep_m = 1e-7;
    const glm::vec2 west = field.slope(p - glm::dvec2(kStep_m, 0.0));
    const glm::vec2 east = field.slope(p + glm::dvec2(kStep_m, 0.0));
    EXPECT_NEAR(static_cast<double>(west.x), static_cast<double>(east.x), 1e-5);
    EXPECT_NEAR(static_cast<double>(west.y), static_cast<double>(east.y), 1e-5);

    constexpr double kDifference_m = 0.05;
    const double rise = static_cast<double>(field.height_m(p + glm::dvec2(kDifference_m, 0.0))) -
                        static_cast<double>(field.height_m(p - glm::dvec2(kDifference_m, 0.0)));
    EXPECT_NEAR(static_cast<double>(east.x), rise / (2.0 * kDifference_m), 0.02);
  }
}

TEST(HeightField, NormalIsOfUnitLengthAndAcrossTheSlope) {
  const HeightField field(rolling_grid(20, 20, 1.0));
  const glm::dvec2 p(107.3, 211.8);
  const glm::vec3 n = field.normal(p);
  const glm::vec2 s = field.slope(p);
  EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1.0f, 1e-6f);
  EXPECT_NEAR(n.x + n.z * s.x, 0.0f, 1e-6f);
  EXPECT_NEAR(n.y + n.z * s.y, 0.0f, 1e-6f);
}

TEST(HeightField, BeyondTheBorderIsTheBordersHeight) {
  const NodeGrid grid = rolling_grid(10, 10, 1.0);
  const HeightField field(grid);
  EXPECT_EQ(field.height_m({-1e7, -1e7}), grid.values()[0]);
  EXPECT_EQ(field.height_m({1e300, 204.0}), field.height_m({109.0, 204.0}));
  EXPECT_EQ(field.slope({-50.0, 204.5}).x, 0.0f);
}

TEST(HeightField, LatticeHasTheBitsOfSinglePoints) {
  for (const bool repeats : {false, true}) {
    const HeightField field(rolling_grid(30, 20, 1.0, repeats));
    for (const double step_m : {0.05, 0.3, 1.0, 3.9, 7.0}) {
      const glm::dvec2 origin_m(95.3, 190.2);
      const int columns = 70, rows = 150;
      std::vector<float> heights(static_cast<std::size_t>(columns * rows));
      field.sample_lattice(origin_m, step_m, columns, rows, heights);
      for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
          ASSERT_EQ(heights[static_cast<std::size_t>(j * columns + i)],
                    field.height_m(origin_m + step_m * glm::dvec2(i, j)));
        }
      }
    }
  }
}

TEST(HeightField, RangeContainsTheSurface) {
  std::mt19937 random(11);
  // White noise overshoots more than any ground.
  std::uniform_real_distribution<float> height(-10.0f, 10.0f);
  for (const bool repeats : {false, true}) {
    std::vector<float> values(61 * 47);
    for (float& v : values) v = height(random);
    const HeightField field(NodeGrid({61, 47, 1.0, {0.0, 0.0}, repeats}, 1, std::move(values)));
    std::uniform_real_distribution<double> corner(-8.0, 66.0), side(0.0, 30.0), unit(0.0, 1.0);
    for (int k = 0; k < 300; ++k) {
      const glm::dvec2 low(corner(random), corner(random));
      const glm::dvec2 size(side(random), side(random));
      const HeightRange range = field.range(low, low + size);
      for (int n = 0; n < 200; ++n) {
        const float z = field.height_m(low + size * glm::dvec2(unit(random), unit(random)));
        ASSERT_GE(z, range.min_m);
        ASSERT_LE(z, range.max_m);
      }
    }
  }
}

TEST(HeightField, KnowsWhichGroundWasMeasured) {
  NodeGrid grid = rolling_grid(20, 20, 1.0);
  grid.values()[10 * 20 + 10] = kNaN;
  const HeightField field(grid);
  EXPECT_TRUE(std::isfinite(field.height_m({110.0, 210.0})));
  EXPECT_FALSE(field.has_data({110.0, 210.0}, {110.0, 210.0}));
  // A node carries the surface for two nodes around it.
  EXPECT_FALSE(field.has_data({111.5, 211.5}, {111.6, 211.6}));
  EXPECT_TRUE(field.has_data({112.0, 212.0}, {115.0, 215.0}));
  EXPECT_TRUE(field.has_data({100.0, 200.0}, {108.0, 219.0}));
  EXPECT_FALSE(field.has_data({100.0, 200.0}, {108.1, 219.0}));
  EXPECT_FALSE(field.has_data({99.0, 200.0}, {101.0, 201.0}));
}

TEST(HeightField, WithoutAnyNodeIsRefused) {
  EXPECT_THROW(HeightField(NodeGrid({2, 2, 1.0, {0.0, 0.0}, false}, 1, std::vector<float>(4, kNaN))),
               BadInput);
}

TEST(HeightField, MayBeASingleNodeOrNothingButLevel) {
  const HeightField level;
  EXPECT_TRUE(level.is_uniform());
  EXPECT_EQ(level.height_m({1e6, 5.0}), 0.0f);
  EXPECT_TRUE(level.has_data({-1e6, 0.0}, {1e6, 1.0}));
  std::vector<float> heights(4, 1.0f);
  level.sample_lattice({0.0, 0.0}, 1.0, 2, 2, heights);
  EXPECT_EQ(heights, std::vector<float>(4, 0.0f));

  const HeightField node(NodeGrid({1, 1, 1.0, {0.0, 0.0}, false}, 1, {7.0f}));
  EXPECT_EQ(node.height_m({0.0, 0.0}), 7.0f);
  EXPECT_EQ(node.slope({0.0, 0.0}), glm::vec2(0.0f));
}

}  // namespace
}  // namespace prairie
