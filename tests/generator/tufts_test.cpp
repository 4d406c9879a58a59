// Tufts: blades that stand together share height, lean and hue; nothing jumps where tufts or cells meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "generator/plant.h"
#include "shaders/kernels/kernels.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr std::uint32_t kSeed = 77;

double difference(const Kernels::Clump& a, const Kernels::Clump& b) {
  const float parts[] = {a.height - b.height,      a.hue - b.hue,       a.dryness - b.dryness,
                         a.lean.x - b.lean.x,      a.lean.y - b.lean.y, a.outward.x - b.outward.x,
                         a.outward.y - b.outward.y};
  double largest = 0.0;
  for (const float part : parts) largest = std::max(largest, static_cast<double>(std::abs(part)));
  return largest;
}

/// Values differ by at most 2 and a weight (r² + 0.03)⁻³ changes by at most 17 times itself per tuft
/// distance; blended, a value changes by at most 20 tuft values per tuft distance.
TEST(TuftsTest, ChangeContinuously) {
  std::mt19937 random(41);
  std::uniform_real_distribution<float> place(-3.0f, 3.0f);
  std::uniform_real_distribution<float> direction(-1.0f, 1.0f);
  double steepest = 0.0;
  constexpr float kStep = 1.0f / 4096.0f;
  for (int n = 0; n < 400000; ++n) {
    const glm::vec2 a(place(random), place(random));
    const glm::vec2 b = a + kStep * glm::vec2(direction(random), direction(random));
    const double moved = std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    const double change =
        difference(Kernels{}.clump_at({10, -4}, a, kSeed), Kernels{}.clump_at({10, -4}, b, kSeed));
    if (moved > 0.25 * static_cast<double>(kStep)) steepest = std::max(steepest, change / moved);
  }
  std::printf("steepest change: %.1f per tuft distance\n", steepest);
  EXPECT_LE(steepest, 20.0);
}

/// Where the four plants around a place change to another four, and from one lattice cell to the next.
TEST(TuftsTest, DoNotJumpOnTheLatticesLines) {
  double largest = 0.0;
  for (int line = -2; line <= 2; ++line) {
    for (int n = 0; n < 2000; ++n) {
      const float along = -2.0f + 0.002f * static_cast<float>(n);
      for (const float at : {static_cast<float>(line), static_cast<float>(line) + 0.5f}) {
        const float below = std::nextafter(at, -10.0f);
        const auto clump = [&](float x, float y) { return Kernels{}.clump_at({-3, 8}, {x, y}, kSeed); };
        largest = std::max(largest, difference(clump(at, along), clump(below, along)));
        largest = std::max(largest, difference(clump(along, at), clump(along, below)));
      }
    }
  }
  EXPECT_LE(largest, 2e-5);
}

TEST(TuftsTest, AreTheSameFromEveryLatticeCell) {
  double largest = 0.0;
  for (int n = 0; n < 10000; ++n) {
    const glm::vec2 offset(0.37f + 0.0001f * static_cast<float>(n), 0.81f);
    const Kernels::Clump here = Kernels{}.clump_at({5, 6}, offset, kSeed);
    const Kernels::Clump there = Kernels{}.clump_at({4, 8}, offset + glm::vec2(1.0f, -2.0f), kSeed);
    largest = std::max(largest, difference(here, there));
  }
  EXPECT_LE(largest, 2e-5);
}

struct Placed {
  glm::dvec2 position_m;
  Blade blade;
};

std::vector<Placed> tufted_field(float clump_strength) {
  Meadow meadow = level_meadow(16.0, uniform_density(300.0));
  meadow.species[0].species.params.clump_strength = clump_strength;
  std::vector<Placed> placed;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      for (const Blade& blade : plant_tile(meadow, {i, j})) {
        placed.push_back({tile_origin_m(meadow, {i, j}) + glm::dvec2(blade.root_m), blade});
      }
    }
  }
  return placed;
}

/// Correlation of a value between blades less than 3 cm apart (`across`: on different sides of a cell's
/// border) or, with `far`, about 2 m apart.
template <typename Value>
double neighbour_correlation(const std::vector<Placed>& field, bool across, bool far, const Value& value) {
  double sum = 0.0, squares = 0.0;
  for (const Placed& p : field) sum += static_cast<double>(value(p.blade));
  const double mean = sum / static_cast<double>(field.size());
  for (const Placed& p : field) squares += std::pow(static_cast<double>(value(p.blade)) - mean, 2);
  const double variance = squares / static_cast<double>(field.size());

  std::vector<std::vector<const Placed*>> buckets(400 * 400);
  const auto bucket = [](glm::dvec2 p) {
    return static_cast<std::size_t>(static_cast<int>(p.y / 0.04) * 400 + static_cast<int>(p.x / 0.04));
  };
  for (const Placed& p : field) buckets[bucket(p.position_m)].push_back(&p);
  double products = 0.0, pairs = 0.0;
  for (const Placed& p : field) {
    const glm::dvec2 shifted = p.position_m + (far ? glm::dvec2(2.03, 0.0) : glm::dvec2(0.0));
    if (shifted.x > 15.9) continue;
    for (const std::size_t beside : {bucket(shifted) - 1, bucket(shifted), bucket(shifted) + 1}) {
      if (beside >= buckets.size()) continue;
      for (const Placed* q : buckets[beside]) {
        if (q == &p || glm::distance(q->position_m, shifted) > 0.03) continue;
        if (across && std::floor(q->position_m.x / 2.0) == std::floor(p.position_m.x / 2.0)) continue;
        products +=
            (static_cast<double>(value(p.blade)) - mean) * (static_cast<double>(value(q->blade)) - mean);
        pairs += 1.0;
      }
    }
  }
  EXPECT_GT(pairs, 200.0);
  return products / pairs / variance;
}

float height(const Blade& blade) {
  return blade.height_m;
}
float hue(const Blade& blade) {
  return blade.hue;
}
float lean(const Blade& blade) {
  return blade.lean.x;
}

TEST(TuftsTest, NeighboursShareHeightHueAndLean) {
  const std::vector<Placed> field = tufted_field(1.0f);
  std::printf("neighbours' correlation: height %.2f, hue %.2f, lean %.2f\n",
              neighbour_correlation(field, false, false, height),
              neighbour_correlation(field, false, false, hue),
              neighbour_correlation(field, false, false, lean));
  EXPECT_GE(neighbour_correlation(field, false, false, height), 0.4);
  EXPECT_GE(neighbour_correlation(field, false, false, hue), 0.4);
  EXPECT_GE(neighbour_correlation(field, false, false, lean), 0.4);
}

TEST(TuftsTest, ReachAcrossCellBorders) {
  const std::vector<Placed> field = tufted_field(1.0f);
  EXPECT_GE(neighbour_correlation(field, true, false, height), 0.35);
  EXPECT_GE(neighbour_correlation(field, true, false, hue), 0.35);
  EXPECT_GE(neighbour_correlation(field, true, false, lean), 0.35);
}

TEST(TuftsTest, EndWhereTheyEnd) {
  const std::vector<Placed> tufted = tufted_field(1.0f);
  EXPECT_NEAR(neighbour_correlation(tufted, false, true, height), 0.0, 0.15);
  EXPECT_NEAR(neighbour_correlation(tufted, false, true, hue), 0.0, 0.15);
  const std::vector<Placed> loose = tufted_field(0.0f);
  EXPECT_NEAR(neighbour_correlation(loose, false, false, height), 0.0, 0.05);
  EXPECT_NEAR(neighbour_correlation(loose, false, false, hue), 0.0, 0.05);
}

TEST(TuftsTest, WorldsHaveTheirOwn) {
  const Kernels::Clump a = Kernels{}.clump_at({1, 2}, {0.3f, 0.3f}, 1);
  const Kernels::Clump b = Kernels{}.clump_at({1, 2}, {0.3f, 0.3f}, 2);
  EXPECT_NE(a.height, b.height);
}

}  // namespace
}  // namespace prairie
