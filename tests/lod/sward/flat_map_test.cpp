// The flat tier's texture tells the blades' own colour, whatever their length, and lies where the maps lie.
#include "lod/sward/flat_map.h"

#include <gtest/gtest.h>

#include <array>

#include "generator/meadow.h"

namespace prairie {
namespace {

constexpr std::array kAreaFromAbove{0.0006};  // of one blade, m²

Meadow uniform_meadow(float blade_height) {
  Meadow meadow;
  meadow.extent_m = {10.0, 6.0};
  PlantedSpecies grass;
  grass.species.name = "grass";
  grass.species.params.height_m = 0.4f;
  grass.species.params.width_m = 0.004f;
  grass.species.params.root_color = {0.04f, 0.07f, 0.02f};
  grass.species.params.tip_color = {0.2f, 0.3f, 0.06f};
  grass.density_per_m2 = NodeGrid::uniform(900.0f);
  meadow.species.push_back(grass);
  meadow.blade_height = NodeGrid::uniform(blade_height);
  return meadow;
}

TEST(FlatMapTest, LengthOfBladesChangesCoverAlone) {
  const FlatMap low = make_flat_map(uniform_meadow(0.5f), kAreaFromAbove);
  const FlatMap tall = make_flat_map(uniform_meadow(2.0f), kAreaFromAbove);
  ASSERT_EQ(low.srgb_and_cover.size(), tall.srgb_and_cover.size());
  for (std::size_t n = 0; n < low.srgb_and_cover.size(); ++n) {
    if (n % 4 == 3) {
      EXPECT_LT(low.srgb_and_cover[n], tall.srgb_and_cover[n]);
    } else {
      EXPECT_EQ(low.srgb_and_cover[n], tall.srgb_and_cover[n]);
    }
  }
}

TEST(FlatMapTest, TexelsLieOnTheBordersOrRepeatWithTheField) {
  Meadow meadow = uniform_meadow(1.0f);
  const FlatMap bordered = make_flat_map(meadow, kAreaFromAbove);
  EXPECT_NEAR(bordered.period_m.x * (bordered.columns - 1) / bordered.columns, 10.0, 1e-9);
  EXPECT_NEAR(bordered.period_m.y * (bordered.rows - 1) / bordered.rows, 6.0, 1e-9);
  meadow.repeats = true;
  const FlatMap repeated = make_flat_map(meadow, kAreaFromAbove);
  EXPECT_NEAR(repeated.period_m.x, 10.0, 1e-9);
  EXPECT_NEAR(repeated.period_m.y, 6.0, 1e-9);
}

}  // namespace
}  // namespace prairie
