// Where nothing grows: density 0, nodata in any map, beyond the field's border.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "generator/plant.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

template <typename Visit>
void for_each_blade(const Meadow& meadow, const Visit& visit) {
  const TileRange tiles = tiles_of(meadow);
  for (int j = tiles.first.j - 1; j <= tiles.last.j + 1; ++j) {
    for (int i = tiles.first.i - 1; i <= tiles.last.i + 1; ++i) {
      for (const Blade& blade : plant_tile(meadow, {i, j})) {
        visit(tile_origin_m(meadow, {i, j}) + glm::dvec2(blade.root_m));
      }
    }
  }
}

std::size_t blade_count(const Meadow& meadow) {
  std::size_t count = 0;
  for_each_blade(meadow, [&](glm::dvec2) { ++count; });
  return count;
}

// Rounding of a position inside a tile of 4 m.
constexpr double kRoundingM = 1e-6;

TEST(BareGroundTest, DensityZeroStaysBare) {
  EXPECT_EQ(blade_count(level_meadow(20.0, uniform_density(0.0))), 0u);
  // A strip of zero nodes, whose neighbours carry 1000/m²: bare between the strip's nodes, thinning towards
  // it.
  for (const double spacing_m : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    const Meadow meadow = level_meadow(24.0, grid_from(square_frame(24.0, spacing_m), [](glm::dvec2 p) {
                                         return p.x >= 8.0 && p.x <= 16.0 ? 0.0 : 1000.0;
                                       }));
    std::size_t blades = 0, in_strip = 0;
    for_each_blade(meadow, [&](glm::dvec2 p) {
      ++blades;
      in_strip += p.x > 8.0 + kRoundingM && p.x < 16.0 - kRoundingM;
    });
    EXPECT_EQ(in_strip, 0u) << spacing_m;
    EXPECT_GT(blades, 250000u) << spacing_m;
  }
}

TEST(BareGroundTest, DensityNodataStaysBare) {
  for (const double spacing_m : {0.25, 1.0, 2.0, 4.0}) {
    const NodeGrid density = grid_from(square_frame(24.0, spacing_m), [](glm::dvec2 p) {
      return p.x >= 8.0 && p.x <= 12.0 && p.y >= 8.0 && p.y <= 12.0 ? static_cast<double>(kNaN) : 500.0;
    });
    const Meadow meadow = level_meadow(24.0, density);
    std::size_t blades = 0, on_nodata = 0;
    for_each_blade(meadow, [&](glm::dvec2 p) {
      ++blades;
      on_nodata += std::isnan(density.sample(p));
    });
    // No blade has a node without data among the four around it; all other squares are planted whole.
    const double bare_m2 = (4.0 + 2.0 * spacing_m) * (4.0 + 2.0 * spacing_m);
    EXPECT_EQ(on_nodata, 0u) << spacing_m;
    EXPECT_NEAR(static_cast<double>(blades), 500.0 * (24.0 * 24.0 - bare_m2), 40.0) << spacing_m;
  }
}

TEST(BareGroundTest, MisalignedNodataStaysBare) {
  for (const double spacing_m : {0.1, 0.7, 1.3}) {
    const int nodes = static_cast<int>(26.0 / spacing_m);
    const NodeGrid density = grid_from({nodes, nodes, spacing_m, {-0.33, -0.21}, false}, [](glm::dvec2 p) {
      return p.x >= 8.0 && p.x <= 12.0 && p.y >= 8.0 && p.y <= 12.0 ? static_cast<double>(kNaN) : 500.0;
    });
    std::size_t on_nodata = 0;
    for_each_blade(level_meadow(24.0, density),
                   [&](glm::dvec2 p) { on_nodata += std::isnan(density.sample(p)); });
    EXPECT_EQ(on_nodata, 0u) << spacing_m;
  }
}

TEST(BareGroundTest, HeightNodataStaysBare) {
  for (const double spacing_m : {0.5, 1.0, 4.0, 5.0}) {
    Meadow meadow = level_meadow(40.0, uniform_density(100.0));
    meadow.ground = HeightField(grid_from(square_frame(40.0, spacing_m), [](glm::dvec2 p) {
      return p.x > 9.0 && p.x < 11.0 && p.y > 9.0 ? static_cast<double>(kNaN) : 0.1 * p.x;
    }));
    std::size_t blades = 0, on_nodata = 0;
    for_each_blade(meadow, [&](glm::dvec2 p) {
      ++blades;
      on_nodata += !meadow.ground.has_data(p, p);
    });
    EXPECT_EQ(on_nodata, 0u) << spacing_m;
    EXPECT_GT(blades, 10000u) << spacing_m;
  }
}

TEST(BareGroundTest, BordersOfMapsStayBare) {
  // The density map ends inside the field.
  const Meadow meadow =
      level_meadow(24.0, grid_from({11, 11, 1.0, {5.0, 5.0}, false}, [](glm::dvec2) { return 400.0; }));
  std::size_t blades = 0;
  for_each_blade(meadow, [&](glm::dvec2 p) {
    ++blades;
    EXPECT_TRUE(p.x >= 5.0 - kRoundingM && p.x <= 15.0 + kRoundingM && p.y >= 5.0 - kRoundingM &&
                p.y <= 15.0 + kRoundingM);
  });
  EXPECT_NEAR(static_cast<double>(blades), 400.0 * 100.0, 40.0);
}

/// A field whose border crosses cells is planted up to the last eighth of a cell (0.25 m) that fits, and
/// never beyond.
TEST(BareGroundTest, FieldEndsAtItsBorder) {
  for (const double extent_m : {10.0, 9.25, 9.1, 0.5}) {
    const Meadow meadow = level_meadow(extent_m, uniform_density(400.0));
    std::size_t blades = 0, beyond = 0;
    for_each_blade(meadow, [&](glm::dvec2 p) {
      ++blades;
      beyond += p.x < 0.0 || p.y < 0.0 || p.x > extent_m + kRoundingM || p.y > extent_m + kRoundingM;
    });
    const double planted_m = 0.25 * std::floor(extent_m / 0.25 + 1e-9);
    EXPECT_EQ(beyond, 0u) << extent_m;
    EXPECT_NEAR(static_cast<double>(blades), 400.0 * planted_m * planted_m, 10.0) << extent_m;
  }
}

TEST(BareGroundTest, RepeatedFieldHasNoBorder) {
  Meadow meadow = level_meadow(8.0, uniform_density(100.0));
  meadow.repeats = true;
  EXPECT_EQ(planted_count(meadow, {-300, 700}), 1600u);
  EXPECT_NE(tile_hash(meadow, {0, 0}), tile_hash(meadow, {2, 0})) << "the maps repeat, the blades do not";
}

}  // namespace
}  // namespace prairie
