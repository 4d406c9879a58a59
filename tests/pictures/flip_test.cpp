// FLIP against its printed formulas in double, and against what it is for: detail too fine to be seen is
// forgiven, lost edges are not.
#include "pictures/flip.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "tests/pictures/flip_as_printed.h"

namespace prairie {
namespace {

constexpr double kPixelsPerDegree = 67.02;

using Bytes = std::uint8_t[3];

struct TestPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
  SrgbImage image() const { return {width, height, bytes}; }
};

TestPicture picture(int width, int height, const std::function<std::array<int, 3>(int x, int y)>& color) {
  TestPicture result{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const int channel : color(x, y)) result.bytes.push_back(static_cast<std::uint8_t>(channel));
    }
  }
  return result;
}

TestPicture grey_picture(int width, int height, const std::function<int(int x, int y)>& grey) {
  return picture(width, height, [&](int x, int y) {
    const int value = grey(x, y);
    return std::array<int, 3>{value, value, value};
  });
}

TestPicture uniform(const Bytes& color) {
  return picture(20, 14, [&](int, int) { return std::array<int, 3>{color[0], color[1], color[2]}; });
}

TestPicture noise(int width, int height, unsigned seed, int least = 0, int most = 255) {
  std::mt19937 random(seed);
  const auto byte = [&] {
    return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
  };
  return picture(width, height, [&](int, int) { return std::array<int, 3>{byte(), byte(), byte()}; });
}

double flip(const TestPicture& reference, const TestPicture& test,
            double pixels_per_degree = kPixelsPerDegree) {
  return mean_flip(reference.image(), test.image(), pixels_per_degree);
}

TEST(FlipTest, EqualPicturesDoNotDiffer) {
  const TestPicture some = noise(40, 30, 1);
  EXPECT_EQ(flip(some, some), 0.0);
}

TEST(FlipTest, IsSymmetric) {
  const TestPicture one = noise(40, 30, 1), other = noise(40, 30, 2);
  EXPECT_EQ(flip(one, other), flip(other, one));
}

TEST(FlipTest, UniformPicturesDifferAsTheirColors) {
  const Bytes colors[] = {{0, 0, 0}, {255, 255, 255}, {255, 0, 0},    {0, 255, 0},    {0, 0, 255},
                          {3, 2, 1}, {90, 120, 40},   {100, 120, 40}, {128, 128, 128}};
  for (const Bytes& one : colors) {
    for (const Bytes& other : colors) {
      EXPECT_NEAR(flip(uniform(one), uniform(other)), uniform_flip_as_printed(one, other), 2e-6)
          << int{one[0]} << ' ' << int{one[1]} << ' ' << int{one[2]} << " against " << int{other[0]} << ' '
          << int{other[1]} << ' ' << int{other[2]};
    }
  }
}

/// From the formulas by hand: L* of black and white are 100 apart, 100^0.7 = 25.12; green and blue are 203.3
/// apart after Hunt's adjustment, 203.3^0.7 = 41.3, two fifths of which are 16.5; 0.95 + 0.05 (25.12
/// − 16.5)/(41.3 − 16.5).
TEST(FlipTest, BlackAndWhiteDifferNearlyAsMuchAsCanBe) {
  EXPECT_NEAR(flip(uniform({0, 0, 0}), uniform({255, 255, 255})), 0.9674, 2e-4);
  EXPECT_NEAR(flip(uniform({0, 255, 0}), uniform({0, 0, 255})), 1.0, 1e-6);
}

TEST(FlipTest, GrowsWithTheDifferenceOfGreys) {
  double last = 0.0;
  for (int grey = 41; grey < 256; grey += 6) {
    const Bytes lighter = {static_cast<std::uint8_t>(grey), static_cast<std::uint8_t>(grey),
                           static_cast<std::uint8_t>(grey)};
    const double difference = flip(uniform({40, 40, 40}), uniform(lighter));
    EXPECT_GT(difference, last) << grey;
    last = difference;
  }
}

TEST(FlipTest, IsThePrintedFormulas) {
  const TestPicture random = noise(31, 23, 3);
  const TestPicture other_random = noise(31, 23, 4, 60, 200);
  const TestPicture disc = picture(31, 23, [](int x, int y) {
    return std::hypot(x - 12.0, y - 10.0) < 7.0 ? std::array<int, 3>{220, 180, 20}
                                                : std::array<int, 3>{30, 90, 40};
  });
  for (const double pixels_per_degree : {1.0, 8.0, 30.0, kPixelsPerDegree}) {
    for (const auto& [one, other] :
         {std::pair(&random, &other_random), std::pair(&disc, &random), std::pair(&disc, &other_random)}) {
      EXPECT_NEAR(flip(*one, *other, pixels_per_degree),
                  flip_as_printed(one->image(), other->image(), pixels_per_degree), 2e-6)
          << pixels_per_degree;
    }
  }
}

TEST(FlipTest, TakesPicturesSmallerThanItsFilters) {
  const TestPicture one = noise(1, 1, 5), other = noise(1, 1, 6);
  EXPECT_NEAR(flip(one, other), flip_as_printed(one.image(), other.image(), kPixelsPerDegree), 2e-6);
  const TestPicture row = noise(9, 1, 5), other_row = noise(9, 1, 6);
  EXPECT_NEAR(flip(row, other_row), flip_as_printed(row.image(), other_row.image(), kPixelsPerDegree), 2e-6);
}

TEST(FlipTest, LostLinesAndEdgesAreWorseThanTheirColors) {
  const TestPicture plain = grey_picture(60, 20, [](int, int) { return 100; });
  const TestPicture line = grey_picture(60, 20, [](int x, int) { return x == 30 ? 250 : 100; });
  const TestPicture ramp = grey_picture(60, 20, [](int x, int) { return 100 + x / 6; });
  const auto feature_share = [&](const TestPicture& picture) {
    return flip(plain, picture) /
           flip_as_printed(plain.image(), picture.image(), kPixelsPerDegree, FlipTerms::kColor);
  };
  EXPECT_GT(feature_share(line), 1.2);
  EXPECT_LT(feature_share(ramp), feature_share(line));
}

TEST(FlipTest, FineNoiseIsForgivenFromFarAway) {
  const TestPicture one = noise(80, 60, 7, 90, 150), other = noise(80, 60, 8, 90, 150);
  double last = 1.0;
  for (const double pixels_per_degree : {10.0, 30.0, 67.0, 150.0, 400.0}) {
    const double difference = flip(one, other, pixels_per_degree);
    EXPECT_LT(difference, last) << pixels_per_degree;
    last = difference;
  }
  EXPECT_LT(last, 0.25 * flip(one, other, 10.0));
}

/// Stripes eight pixels apart against the same with every row shifted by up to half a pixel, and against
/// their mean.
TEST(FlipTest, AlmostTheSameStripesAreNearerThanNone) {
  std::mt19937 random(9);
  double shift = 0.0;
  const auto stripes = [&](int x, int) {
    return static_cast<int>(120.0 + 90.0 * std::sin(0.8 * (x + shift)));
  };
  const TestPicture sharp = grey_picture(80, 60, stripes);
  const TestPicture jittered = grey_picture(80, 60, [&](int x, int y) {
    if (x == 0) shift = static_cast<double>(random() % 1001) / 1000.0 - 0.5;
    return stripes(x, y);
  });
  const TestPicture blurred = grey_picture(80, 60, [](int, int) { return 120; });
  EXPECT_GT(flip(sharp, jittered), 0.0);
  EXPECT_LT(flip(sharp, jittered), 0.5 * flip(sharp, blurred));
}

TEST(FlipTest, DoesNotDependOnTheNumberOfThreads) {
  const TestPicture one = noise(120, 90, 10), other = noise(120, 90, 11);
  const double many = flip(one, other);
  const oneapi::tbb::global_control single(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(flip(one, other), many);
}

}  // namespace
}  // namespace prairie
