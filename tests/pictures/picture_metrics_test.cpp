// The measures on pictures whose means, deviations and changes are known beforehand.
#include "pictures/picture_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace prairie {
namespace {

struct TestPicture {
  int width = 0;
  int height = 0;
  std::vector<float> values;
  LinearImage image() const { return {width, height, values}; }
  PixelRect all() const { return {0, 0, width, height}; }
};

TestPicture picture(int width, int height, const std::function<glm::dvec3(int x, int y)>& color) {
  TestPicture result{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        result.values.push_back(static_cast<float>(color(x, y)[channel]));
      }
    }
  }
  return result;
}

TEST(PictureMetricsTest, MeanColorIsThatOfTheRectangleAlone) {
  const TestPicture some = picture(7, 5, [](int x, int y) {
    const bool inside = x >= 2 && x < 5 && y >= 1 && y < 3;
    return inside ? glm::dvec3(x, 10.0 * y, -1.0) : glm::dvec3(1000.0);
  });
  const glm::dvec3 mean = mean_color(some.image(), {2, 1, 3, 2});
  EXPECT_DOUBLE_EQ(mean.x, 3.0);
  EXPECT_DOUBLE_EQ(mean.y, 15.0);
  EXPECT_DOUBLE_EQ(mean.z, -1.0);
  EXPECT_DOUBLE_EQ(mean_color(some.image(), {6, 4, 1, 1}).x, 1000.0);
}

TEST(PictureMetricsTest, BlocksAreWholeAndInRows) {
  // 3 × 2 blocks of 4 × 4 pixels; what is left at the right and at the bottom counts for none.
  const TestPicture some = picture(14, 11, [](int x, int y) {
    return x >= 12 || y >= 8 ? glm::dvec3(1e6) : glm::dvec3(x / 4, 10 * (y / 4), 100.0);
  });
  const std::vector<double> blocks = block_luminances(some.image(), 4);
  ASSERT_EQ(blocks.size(), 6u);
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      EXPECT_NEAR(blocks[static_cast<std::size_t>(3 * row + column)],
                  0.2126 * column + 0.7152 * 10.0 * row + 0.0722 * 100.0, 1e-6);
    }
  }
}

TEST(PictureMetricsTest, SteadyTrendIsNoTexture) {
  const TestPicture some =
      picture(60, 40, [](int x, int y) { return glm::dvec3(0.2 + 0.003 * x + 0.01 * y); });
  EXPECT_NEAR(luminance_deviation(some.image(), some.all(), 4), 0.0, 1e-7);
  EXPECT_NEAR(luminance_deviation(some.image(), {7, 3, 4, 33}, 4), 0.0, 1e-7) << "one column of blocks";
  EXPECT_EQ(luminance_deviation(some.image(), {7, 3, 4, 4}, 4), 0.0) << "one block";
}

TEST(PictureMetricsTest, DeviationOfACheckerboardIsHalfItsContrast) {
  // 10 × 8 blocks, so that the board has no trend of its own.
  const auto board = [](int x, int y) { return (x / 5 + y / 5) % 2 == 0 ? 0.3 : 0.7; };
  const TestPicture plain = picture(50, 40, [&](int x, int y) { return glm::dvec3(board(x, y)); });
  EXPECT_NEAR(luminance_deviation(plain.image(), plain.all(), 5), 0.2, 1e-6);
  EXPECT_NEAR(luminance_deviation(plain.image(), plain.all(), 10), 0.0, 1e-6) << "finer than the blocks";
  const TestPicture hazy = picture(
      50, 40, [&](int x, int y) { return glm::dvec3(board(x, y) + 0.02 * (y / 5) - 0.01 * (x / 5)); });
  EXPECT_NEAR(luminance_deviation(hazy.image(), hazy.all(), 5), 0.2, 1e-6);
  EXPECT_NEAR(luminance_deviation(plain.image(), {5, 0, 40, 40}, 5), 0.2, 1e-6) << "a part of the picture";
}

TEST(PictureMetricsTest, GreenWeighsMost) {
  const auto deviation_of = [](const glm::dvec3& color) {
    const TestPicture board =
        picture(8, 8, [&](int x, int y) { return (x + y) % 2 == 0 ? color : glm::dvec3(0.0); });
    return luminance_deviation(board.image(), board.all(), 1);
  };
  EXPECT_NEAR(deviation_of({1.0, 0.0, 0.0}), 0.1063, 1e-6);
  EXPECT_NEAR(deviation_of({0.0, 1.0, 0.0}), 0.3576, 1e-6);
  EXPECT_NEAR(deviation_of({0.0, 0.0, 1.0}), 0.0361, 1e-6);
}

TEST(PictureMetricsTest, AStepThatStandsOutShows) {
  // Two blocks; the first changes by 1, 1, 3, 1, the second by less, or downwards.
  const std::vector<std::vector<double>> frames{{0.0, 9.0}, {1.0, 8.5}, {2.0, 8.5}, {2.5, 5.5}, {3.5, 5.5}};
  const StepEvenness evenness = step_evenness(frames);
  EXPECT_DOUBLE_EQ(evenness.largest, 3.0);
  EXPECT_DOUBLE_EQ(evenness.median, 1.0);
  EXPECT_DOUBLE_EQ(evenness.ratio, 3.0);
}

TEST(PictureMetricsTest, MedianOfAnEvenNumberOfStepsLiesBetweenTheMiddleTwo) {
  const std::vector<std::vector<double>> frames{{0.0}, {4.0}, {2.0}};
  EXPECT_DOUBLE_EQ(step_evenness(frames).median, 3.0);
}

TEST(PictureMetricsTest, EvenSequencesHaveRatioOne) {
  std::vector<std::vector<double>> frames;
  for (int n = 0; n < 8; ++n) frames.push_back({0.25 * n, 1.0 - 0.25 * n});
  EXPECT_DOUBLE_EQ(step_evenness(frames).ratio, 1.0);
  const std::vector<std::vector<double>> still(4, {0.5, 0.5});
  EXPECT_EQ(step_evenness(still).ratio, 1.0);
  EXPECT_EQ(step_evenness(still).largest, 0.0);
  std::vector<std::vector<double>> pop = still;
  pop.back() = {0.5, 0.75};
  EXPECT_EQ(step_evenness(pop).ratio, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace prairie
