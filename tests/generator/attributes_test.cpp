// What blades are like: within what their species says, spread as it says, and no two alike by rule.
//
// Thresholds are four standard deviations of the statistic for as many independent blades, unless something
// else is said.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "generator/plant.h"
#include "shaders/kernels/kernels.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

std::vector<Blade> field_of(const Species& species, double extent_m) {
  Meadow meadow = level_meadow(extent_m, uniform_density(200.0));
  meadow.species[0].species = species;
  std::vector<Blade> blades;
  const TileRange tiles = tiles_of(meadow);
  for (int j = 0; j <= tiles.last.j; ++j) {
    for (int i = 0; i <= tiles.last.i; ++i) {
      const std::vector<Blade> tile = plant_tile(meadow, {i, j});
      blades.insert(blades.end(), tile.begin(), tile.end());
    }
  }
  return blades;
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
  double least = 1e30;
  double most = -1e30;
};

template <typename Value>
Moments moments_of(const std::vector<Blade>& blades, const Value& value) {
  Moments m;
  double squares = 0.0;
  for (const Blade& blade : blades) {
    const double x = static_cast<double>(value(blade));
    m.mean += x;
    squares += x * x;
    m.least = std::min(m.least, x);
    m.most = std::max(m.most, x);
  }
  const double count = static_cast<double>(blades.size());
  m.mean /= count;
  m.deviation = std::sqrt(std::max(squares / count - m.mean * m.mean, 0.0));
  return m;
}

/// A number that is uniform in mean · (1 ± spread).
void expect_uniform_spread(const char* name, const Moments& m, float mean, float spread, std::size_t count) {
  const double expected = static_cast<double>(mean);
  const double half = expected * static_cast<double>(spread);
  const double deviation = half / std::sqrt(3.0);
  const double rounding = 1e-6 * expected;
  EXPECT_NEAR(m.mean, expected, 4.0 * deviation / std::sqrt(static_cast<double>(count)) + rounding) << name;
  EXPECT_NEAR(m.deviation, deviation, 0.02 * deviation + rounding) << name;
  EXPECT_GE(m.least, expected - half - rounding) << name;
  EXPECT_LE(m.most, expected + half + rounding) << name;
}

TEST(AttributesTest, AreSpreadAsTheSpeciesSays) {
  const Species grass = test_grass();
  const SpeciesParams& p = grass.params;
  const std::vector<Blade> blades = field_of(grass, 32.0);
  ASSERT_GT(blades.size(), 200000u);
  const auto spread = [&](const char* name, float mean, float share, auto value) {
    expect_uniform_spread(name, moments_of(blades, value), mean, share, blades.size());
  };
  spread("width", p.width_m, p.width_spread, [](const Blade& b) { return b.width_m; });
  spread("curvature", p.curvature_rad, p.curvature_spread, [](const Blade& b) { return b.curvature_rad; });
  spread("stiffness", p.stiffness, p.stiffness_spread, [](const Blade& b) { return b.stiffness; });
  spread("tilt", 0.5f * p.tilt_rad, 1.0f, [](const Blade& b) { return b.tilt_rad; });
  spread("azimuth", std::numbers::pi_v<float>, 1.0f, [](const Blade& b) { return b.azimuth_rad; });
  spread("phase", std::numbers::pi_v<float>, 1.0f, [](const Blade& b) { return b.phase_rad; });
}

TEST(AttributesTest, StayWithinTheirMeaning) {
  for (const float clumps : {0.0f, 0.5f, 1.0f}) {
    Species grass = test_grass();
    grass.params.clump_strength = clumps;
    for (const Blade& blade : field_of(grass, 16.0)) {
      ASSERT_GT(blade.height_m, 0.05f * grass.params.height_m);
      ASSERT_LE(blade.height_m,
                grass.params.height_m * (1.0f + 1.3f * grass.params.height_spread) * 1.00001f);
      ASSERT_TRUE(blade.dryness >= 0.0f && blade.dryness <= 1.0f);
      ASSERT_LE(std::abs(blade.hue), 1.4f * grass.params.hue_spread * 1.00001f);
      ASSERT_GT(blade.mass_g, 0.0f);
      ASSERT_TRUE(blade.root_m.x >= 0.0f && blade.root_m.x < 4.0f && blade.root_m.y >= 0.0f &&
                  blade.root_m.y < 4.0f);
    }
  }
}

TEST(AttributesTest, BladesWithoutTuftsHaveTheSpeciesMeanHeight) {
  Species grass = test_grass();
  grass.params.clump_strength = 0.0f;
  const std::vector<Blade> blades = field_of(grass, 24.0);
  expect_uniform_spread("height", moments_of(blades, [](const Blade& b) { return b.height_m; }),
                        grass.params.height_m, grass.params.height_spread, blades.size());
}

/// The crown makes blades between tufts shorter, so that the mean of a tufted sward lies below the species'
/// height; by how much depends on the tufts alone: less than its strength · 0.45 allows.
TEST(AttributesTest, TuftsLowerTheMeanHeightByTheirCrown) {
  const Species grass = test_grass();
  const Moments height = moments_of(field_of(grass, 40.0), [](const Blade& b) { return b.height_m; });
  const double relative = height.mean / static_cast<double>(grass.params.height_m);
  std::printf("mean height of a tufted sward: %.3f of the species'\n", relative);
  EXPECT_LT(relative, 1.02);
  EXPECT_GT(relative, 1.0 - 0.45 * static_cast<double>(grass.params.clump_strength));
}

TEST(AttributesTest, HeightsFollowTheHeightMapAndTheMassFollowsTheSize) {
  Meadow meadow = level_meadow(8.0, uniform_density(200.0));
  const std::vector<Blade> plain = plant_tile(meadow, {0, 0});
  meadow.blade_height = NodeGrid::uniform(0.5f);
  const std::vector<Blade> mown = plant_tile(meadow, {0, 0});
  ASSERT_EQ(plain.size(), mown.size());
  const SpeciesParams& p = meadow.species[0].species.params;
  for (std::size_t n = 0; n < plain.size(); ++n) {
    ASSERT_FLOAT_EQ(mown[n].height_m, 0.5f * plain[n].height_m);
    ASSERT_FLOAT_EQ(plain[n].mass_g,
                    p.mass_g * (plain[n].height_m / p.height_m) * (plain[n].width_m / p.width_m));
  }
}

/// Successive blades, and blades of the same index in neighbouring cells, have nothing to do with one
/// another.
TEST(AttributesTest, NoCorrelationBetweenBlades) {
  Species grass = test_grass();
  grass.params.clump_strength = 0.0f;
  const std::vector<Blade> blades = field_of(grass, 32.0);
  const std::size_t per_cell = 800;  // 2 m × 2 m at 200/m²
  const auto correlation = [&](std::size_t lag, auto first, auto second) {
    const Moments a = moments_of(blades, first);
    const Moments b = moments_of(blades, second);
    double sum = 0.0;
    for (std::size_t n = 0; n + lag < blades.size(); ++n) {
      sum += (static_cast<double>(first(blades[n])) - a.mean) *
             (static_cast<double>(second(blades[n + lag])) - b.mean);
    }
    return sum / (static_cast<double>(blades.size() - lag) * a.deviation * b.deviation);
  };
  const auto height = [](const Blade& blade) { return blade.height_m; };
  const auto azimuth = [](const Blade& blade) { return blade.azimuth_rad; };
  const auto width = [](const Blade& blade) { return blade.width_m; };
  const auto hue = [](const Blade& blade) { return blade.hue; };
  const double bound = 4.5 / std::sqrt(static_cast<double>(blades.size()));
  for (const std::size_t lag : {std::size_t{1}, std::size_t{2}, std::size_t{64}, per_cell, 2 * per_cell}) {
    EXPECT_LE(std::abs(correlation(lag, height, height)), bound) << lag;
    EXPECT_LE(std::abs(correlation(lag, azimuth, azimuth)), bound) << lag;
    EXPECT_LE(std::abs(correlation(lag, hue, hue)), bound) << lag;
  }
  EXPECT_LE(std::abs(correlation(0, height, width)), bound);
  EXPECT_LE(std::abs(correlation(0, height, hue)), bound);
  EXPECT_LE(std::abs(correlation(0, azimuth, width)), bound);
}

TEST(AttributesTest, TraitsFillTheirRangeEvenly) {
  // 16 classes of 4096 numbers each have a standard deviation of 62.
  std::array<std::array<int, 16>, 11> classes{};
  for (std::uint32_t k = 0; k < 65536; ++k) {
    const Kernels::Traits t = Kernels{}.traits_of(0x1234567u, k);
    const float values[] = {t.height,  t.width,     t.azimuth, t.tilt,   t.curvature, t.hue,
                            t.dryness, t.stiffness, t.phase,   t.lean.x, t.lean.y};
    for (std::size_t n = 0; n < 11; ++n) {
      ASSERT_TRUE(values[n] >= 0.0f && values[n] < 1.0f);
      ++classes[n][static_cast<std::size_t>(16.0f * values[n])];
    }
  }
  for (const auto& of_trait : classes) {
    for (const int count : of_trait) EXPECT_NEAR(count, 4096, 310);
  }
}

/// No two cells plant the same pattern: not neighbours, not far ones, not the species of one cell.
TEST(AttributesTest, CellsDoNotRepeat) {
  Meadow meadow = level_meadow(4.0, uniform_density(10.0));
  meadow.repeats = true;
  meadow.species.push_back(meadow.species[0]);
  std::set<std::pair<float, float>> first_roots;
  std::size_t cells = 0;
  for (int j = -20; j < 20; ++j) {
    for (int i = -20; i < 20; ++i) {
      for (const Blade& blade : plant_tile(meadow, {50 * i, j})) {
        if ((blade.identity & 0xffffffu) != 0) continue;
        ++cells;
        first_roots.insert({std::fmod(blade.root_m.x, 2.0f), blade.azimuth_rad});
      }
    }
  }
  EXPECT_EQ(cells, 40u * 40u * 8u);
  EXPECT_GE(first_roots.size(), cells - 1);
}

}  // namespace
}  // namespace prairie
