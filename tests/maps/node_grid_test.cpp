#include "maps/node_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace prairie {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Serves the nodes of a grid in memory as if they lay elsewhere.
class Elsewhere : public NodeSource {
 public:
  explicit Elsewhere(NodeGrid grid) : grid_(std::move(grid)) {}
  void read(const NodeRect& rect, std::span<float> out) const override {
    EXPECT_GE(rect.column, 0);
    EXPECT_GE(rect.row, 0);
    EXPECT_LE(rect.column + rect.columns, grid_.frame().columns);
    EXPECT_LE(rect.row + rect.rows, grid_.frame().rows);
    grid_.read_block(rect, out);
  }

 private:
  NodeGrid grid_;
};

NodeGrid random_grid(int columns, int rows, int channels, bool repeats) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(-5.0f, 5.0f);
  std::vector<float> values(static_cast<std::size_t>(columns * rows * channels));
  for (float& v : values) v = value(random);
  return NodeGrid({columns, rows, 0.5, {10.0, -20.0}, repeats}, channels, std::move(values));
}

TEST(NodeGrid, BlockInsideIsACopyOfTheNodes) {
  const NodeGrid grid = random_grid(9, 7, 2, false);
  std::vector<float> block(3 * 2 * 2);
  grid.read_block({4, 5, 3, 2}, block);
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(block[j * 6 + k], grid.values()[((5 + j) * 9 + 4) * 2 + k]);
  }
}

TEST(NodeGrid, BlockBeyondTheBorderHoldsTheNearestNodeOrTheRepeatedOne) {
  for (const bool repeats : {false, true}) {
    const NodeGrid grid = random_grid(5, 4, 1, repeats);
    const NodeGrid elsewhere(grid.frame(), 1, std::make_shared<Elsewhere>(grid));
    for (const NodeRect rect : {NodeRect{-7, -6, 20, 17}, NodeRect{3, 2, 4, 4}, NodeRect{-9, 1, 3, 2},
                                NodeRect{11, 9, 2, 1}, NodeRect{-1, 0, 1, 1}}) {
      std::vector<float> block(static_cast<std::size_t>(rect.columns * rect.rows));
      std::vector<float> other(block.size());
      grid.read_block(rect, block);
      elsewhere.read_block(rect, other);
      for (int j = 0; j < rect.rows; ++j) {
        for (int i = 0; i < rect.columns; ++i) {
          const auto border = [repeats](int index, int count) {
            return repeats ? ((index % count) + count) % count : std::min(std::max(index, 0), count - 1);
          };
          const int node = border(rect.row + j, 4) * 5 + border(rect.column + i, 5);
          const std::size_t k = static_cast<std::size_t>(j * rect.columns + i);
          EXPECT_EQ(block[k], grid.values()[static_cast<std::size_t>(node)]);
          EXPECT_EQ(other[k], block[k]);
        }
      }
    }
  }
}

TEST(NodeGrid, SamplesBilinearly) {
  const NodeGrid grid = random_grid(13, 11, 2, false);
  const NodeGrid elsewhere(grid.frame(), 2, std::make_shared<Elsewhere>(grid));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0.0, 11.999), y(0.0, 9.999);
  for (int k = 0; k < 500; ++k) {
    const double u = x(random), v = y(random);
    const int i = static_cast<int>(u), j = static_cast<int>(v);
    const double s = u - i, t = v - j;
    const auto node = [&](int di, int dj) {
      return static_cast<double>(grid.values()[static_cast<std::size_t>(((j + dj) * 13 + i + di) * 2 + 1)]);
    };
    const double oracle = (1 - s) * (1 - t) * node(0, 0) + s * (1 - t) * node(1, 0) +
                          (1 - s) * t * node(0, 1) + s * t * node(1, 1);
    const glm::dvec2 position(10.0 + 0.5 * u, -20.0 + 0.5 * v);
    EXPECT_NEAR(static_cast<double>(grid.sample(position, 1)), oracle, 1e-5);
    EXPECT_EQ(grid.sample(position, 1), elsewhere.sample(position, 1));
  }
}

TEST(NodeGrid, HasNoValueBeyondTheBorder) {
  const NodeGrid grid = random_grid(4, 3, 1, false);
  EXPECT_TRUE(std::isnan(grid.sample({9.99, -20.0})));
  EXPECT_TRUE(std::isnan(grid.sample({10.0, -18.99})));
  EXPECT_EQ(grid.sample({10.0, -20.0}), grid.values()[0]);
  EXPECT_EQ(grid.sample({11.5, -19.0}), grid.values()[11]);
  EXPECT_EQ(grid.sample({10.0 - 1e-9, -20.0}), grid.values()[0]);
  EXPECT_TRUE(std::isnan(grid.sample({std::nan(""), -20.0})));
}

TEST(NodeGrid, RepeatsWithThePeriodOfItsNodes) {
  const NodeGrid grid = random_grid(5, 4, 1, true);
  for (const double shift : {-2.5, 2.5, 250.0}) {
    EXPECT_NEAR(static_cast<double>(grid.sample({10.3, -19.3})),
                static_cast<double>(grid.sample({10.3 + shift, -19.3 + shift * 0.8})), 1e-5);
  }
  // Between the last column and the first.
  const double middle = 0.5 * (static_cast<double>(grid.values()[4]) + static_cast<double>(grid.values()[0]));
  EXPECT_NEAR(static_cast<double>(grid.sample({12.25, -20.0})), middle, 1e-6);
}

TEST(NodeGrid, OneMissingNodeMissesOnlyWhereItContributes) {
  std::vector<float> values(25, 1.0f);
  values[2 * 5 + 2] = kNaN;
  const NodeGrid grid({5, 5, 1.0, {0.0, 0.0}, false}, 1, values);
  EXPECT_TRUE(std::isnan(grid.sample({2.0, 2.0})));
  EXPECT_TRUE(std::isnan(grid.sample({1.5, 2.0})));
  EXPECT_EQ(grid.sample({1.0, 2.0}), 1.0f);
  EXPECT_EQ(grid.sample({2.5, 1.0}), 1.0f);

  EXPECT_FALSE(grid.has_data({0.0, 0.0}, {4.0, 4.0}));
  EXPECT_TRUE(grid.has_data({0.0, 0.0}, {1.0, 4.0}));
  EXPECT_FALSE(grid.has_data({0.0, 0.0}, {1.1, 4.0}));
  EXPECT_TRUE(grid.has_data({3.0, 0.0}, {4.0, 4.0}));
  EXPECT_FALSE(grid.has_data({0.0, 0.0}, {1.0, 4.1}));
  EXPECT_FALSE(grid.has_data({-0.1, 0.0}, {1.0, 1.0}));
}

TEST(NodeGrid, PaintingAHoleIsNoticed) {
  NodeGrid grid = random_grid(5, 5, 1, false);
  EXPECT_TRUE(grid.has_data({10.0, -20.0}, {12.0, -18.0}));
  grid.values()[12] = kNaN;
  EXPECT_FALSE(grid.has_data({10.0, -20.0}, {12.0, -18.0}));
}

TEST(NodeGrid, UniformHasOneValueEverywhere) {
  const NodeGrid grid = NodeGrid::uniform(3.5f);
  EXPECT_TRUE(grid.is_uniform());
  EXPECT_TRUE(grid.values().empty());
  EXPECT_EQ(grid.sample({1e6, -1e6}), 3.5f);
  EXPECT_TRUE(grid.has_data({-1e9, -1e9}, {1e9, 1e9}));
  std::vector<float> block(6);
  grid.read_block({-5, 100, 3, 2}, block);
  for (const float value : block) EXPECT_EQ(value, 3.5f);
}

}  // namespace
}  // namespace prairie
