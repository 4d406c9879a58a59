// The sequence of points: that it is Sobol's, and that scrambling keeps what makes it even.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <random>
#include <set>
#include <vector>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

/// Sobol's second dimension bit by bit: direction numbers of the polynomial x + 1, v_1 = ½, v_k = v_{k−1} ⊕
/// (v_{k−1} ≫ 1).
std::uint32_t sobol_second(std::uint32_t index) {
  std::uint32_t direction = 0x80000000u;
  std::uint32_t point = 0;
  for (; index != 0; index >>= 1) {
    if (index & 1u) point ^= direction;
    direction ^= direction >> 1;
  }
  return point;
}

std::uint32_t reversed_bit_by_bit(std::uint32_t word) {
  std::uint32_t result = 0;
  for (int bit = 0; bit < 32; ++bit) result |= ((word >> bit) & 1u) << (31 - bit);
  return result;
}

TEST(SequenceTest, ReversesBits) {
  std::mt19937 random(1);
  for (int n = 0; n < 10000; ++n) {
    const auto word = static_cast<std::uint32_t>(random());
    ASSERT_EQ(Kernels{}.reverse_bits(word), reversed_bit_by_bit(word));
  }
}

TEST(SequenceTest, SecondDimensionIsSobols) {
  for (std::uint32_t index = 0; index < 100000; ++index) {
    ASSERT_EQ(Kernels{}.reverse_bits(Kernels{}.sobol_reversed_second(index)), sobol_second(index)) << index;
  }
  std::mt19937 random(2);
  for (int n = 0; n < 100000; ++n) {
    const auto index = static_cast<std::uint32_t>(random());
    ASSERT_EQ(Kernels{}.reverse_bits(Kernels{}.sobol_reversed_second(index)), sobol_second(index)) << index;
  }
}

TEST(SequenceTest, ScramblePermutesEachDigitByThoseBelow) {
  std::mt19937 random(3);
  for (int n = 0; n < 20000; ++n) {
    const auto seed = static_cast<std::uint32_t>(random());
    const auto word = static_cast<std::uint32_t>(random());
    const int bit = n % 32;
    const std::uint32_t other = word ^ (1u << bit);
    const std::uint32_t difference =
        Kernels{}.permute_upwards(word, seed) ^ Kernels {}.permute_upwards(other, seed);
    ASSERT_EQ(std::countr_zero(difference), bit) << "a digit stirred others below it, or itself not at all";
  }
}

/// Every prefix of 2^m points, and every aligned block of as many, has one point in each of the 2^m boxes of
/// every shape 2^−a × 2^−(m−a): a (0, 2)-sequence in base 2.
TEST(SequenceTest, EveryElementaryIntervalHoldsOnePoint) {
  std::mt19937 random(4);
  for (int seeds = 0; seeds < 40; ++seeds) {
    const auto seed = static_cast<std::uint32_t>(random());
    for (int m = 0; m <= 10; ++m) {
      for (const std::uint32_t block : {0u, 1u, 5u}) {
        for (int a = 0; a <= m; ++a) {
          std::vector<int> hits(std::size_t{1} << m, 0);
          for (std::uint32_t k = 0; k < (1u << m); ++k) {
            const glm::vec2 point = Kernels{}.sequence_point((block << m) + k, seed);
            ASSERT_TRUE(point.x >= 0.0f && point.x < 1.0f && point.y >= 0.0f && point.y < 1.0f);
            const auto column = static_cast<std::size_t>(point.x * static_cast<float>(1 << a));
            const auto row = static_cast<std::size_t>(point.y * static_cast<float>(1 << (m - a)));
            ++hits[(row << a) + column];
          }
          for (const int hit : hits) ASSERT_EQ(hit, 1) << "seed " << seed << ", m " << m << ", a " << a;
        }
      }
    }
  }
}

/// Any single point falls anywhere alike: over seeds, each of 4 × 4 squares holds point k with probability
/// 1/16. 64 000 seeds give a standard deviation of 61 on 4000; seven times that is beyond chance.
TEST(SequenceTest, EachPointIsUniformOverSeeds) {
  constexpr int kSeeds = 64000;
  for (std::uint32_t k : {0u, 1u, 2u, 3u, 4u, 7u, 76u, 1000u}) {
    std::mt19937 random(5 + k);
    std::array<int, 16> hits{};
    for (int n = 0; n < kSeeds; ++n) {
      const glm::vec2 point = Kernels{}.sequence_point(k, static_cast<std::uint32_t>(random()));
      ++hits[static_cast<std::size_t>(4 * static_cast<int>(4.0f * point.y) +
                                      static_cast<int>(4.0f * point.x))];
    }
    for (std::size_t square = 0; square < hits.size(); ++square) {
      EXPECT_NEAR(hits[square], kSeeds / 16, 430) << "point " << k << ", square " << square;
    }
  }
}

TEST(SequenceTest, SeedsGiveDifferentSequences) {
  std::set<std::pair<float, float>> firsts;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    const glm::vec2 point = Kernels{}.sequence_point(0, seed * 0x9e3779b9u);
    firsts.insert({point.x, point.y});
  }
  EXPECT_EQ(firsts.size(), 1000u);
}

}  // namespace
}  // namespace prairie
