// The strips' texture: at every threshold all levels show about equally many texels, and colours are shares
// of the mean.
#include "lod/sward/strip_texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

/// Blades as upright bars of random rank, height and brightness.
StripDrawing bars() {
  StripDrawing drawing{kStripColumns, kStripRows, {}};
  drawing.rgba.assign(std::size_t{4} * kStripColumns * kStripRows, 0.0f);
  Kernels kernels;
  for (int column = 0; column < drawing.columns; ++column) {
    const auto seed = static_cast<std::uint32_t>(column) * 7919u;
    const float rank = kernels.unit_from_u32(kernels.hash_u32(seed));
    const int top = static_cast<int>(40.0f * kernels.unit_from_u32(kernels.hash_u32(seed + 1u)));
    const float light = 0.1f + kernels.unit_from_u32(kernels.hash_u32(seed + 2u));
    for (int row = 0; row < drawing.rows; ++row) {
      float* texel = &drawing.rgba[4 * (static_cast<std::size_t>(row) * drawing.columns + column)];
      texel[0] = light;
      texel[1] = 2.0f * light;
      texel[2] = 0.5f * light;
      texel[3] = row < top ? rank : 1.0f;
    }
  }
  return drawing;
}

double shown_share(const StripLevel& level, int threshold) {
  std::size_t shown = 0;
  for (std::size_t n = 3; n < level.rgba.size(); n += 4) shown += level.rgba[n] < threshold;
  return static_cast<double>(shown) / static_cast<double>(level.rgba.size() / 4);
}

TEST(StripTextureTest, LevelsShowEquallyMuchAtEveryThreshold) {
  const std::vector<StripLevel> levels = strip_levels(bars());
  ASSERT_EQ(levels.size(), 10u);
  for (const int threshold : {30, 100, 180, 255}) {
    const double wanted = shown_share(levels[0], threshold);
    for (std::size_t n = 1; n < 5; ++n) {
      // A level's texels are a random choice of the finest one's.
      const double texels = static_cast<double>(levels[n].rgba.size() / 4);
      EXPECT_NEAR(shown_share(levels[n], threshold), wanted, 4.0 * std::sqrt(wanted / texels)) << n;
    }
  }
}

TEST(StripTextureTest, ColorsAreSharesOfTheirMean) {
  const std::vector<StripLevel> levels = strip_levels(bars());
  for (std::size_t n = 0; n < 3; ++n) {
    double sum[3] = {0.0, 0.0, 0.0};
    double blades = 0.0;
    for (std::size_t texel = 0; texel < levels[n].rgba.size(); texel += 4) {
      if (levels[n].rgba[texel + 3] == 255) continue;
      for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += levels[n].rgba[texel + channel];
      blades += 1.0;
    }
    for (const double channel : sum)
      EXPECT_NEAR(channel / blades / 255.0 * static_cast<double>(kBrightest), 1.0, 0.03) << n;
  }
}

TEST(StripTextureTest, RowsWithHardlyABladeAreCutOff) {
  EXPECT_NEAR(standing_share(bars()), 40.0f / kStripRows, 0.05f);
  StripDrawing nothing{8, 8, std::vector<float>(4 * 64, 1.0f)};
  EXPECT_EQ(standing_share(nothing), 0.0f);
}

}  // namespace
}  // namespace prairie
