#include "lod/sward/strip_texture.h"

#include <algorithm>
#include <cmath>

#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

constexpr std::uint8_t kNoBlade = 255;
// Rows that share a mean: high up, a row holds the tips of a few blades only.
constexpr int kRowsOfMean = 9;

struct ColorSum {
  double rgb[3] = {};
  double texels = 0.0;
};

// A few glints must not dim all the rest of what 8 bits hold.
double clamped(double radiance, double mean) {
  return std::min(radiance, static_cast<double>(kBrightest) * mean);
}

// The mean radiance around each row.
std::vector<ColorSum> row_means(const StripDrawing& drawing) {
  std::vector<ColorSum> sums(static_cast<std::size_t>(drawing.rows));
  for (int row = 0; row < drawing.rows; ++row) {
    for (int column = 0; column < drawing.columns; ++column) {
      const float* texel = &drawing.rgba[4 * (static_cast<std::size_t>(row) * drawing.columns + column)];
      if (texel[3] >= 1.0f) continue;
      for (int channel = 0; channel < 3; ++channel)
        sums[row].rgb[channel] += static_cast<double>(texel[channel]);
      sums[row].texels += 1.0;
    }
  }
  std::vector<ColorSum> means(sums.size());
  for (int row = 0; row < drawing.rows; ++row) {
    ColorSum around;
    for (int n = std::max(0, row - kRowsOfMean / 2); n <= std::min(drawing.rows - 1, row + kRowsOfMean / 2);
         ++n) {
      for (int channel = 0; channel < 3; ++channel) around.rgb[channel] += sums[n].rgb[channel];
      around.texels += sums[n].texels;
    }
    for (int channel = 0; channel < 3; ++channel)
      means[row].rgb[channel] = around.texels > 0.0 ? around.rgb[channel] / around.texels : 1.0;
  }
  return means;
}

StripLevel finest_level(const StripDrawing& drawing) {
  const std::vector<ColorSum> means = row_means(drawing);
  StripLevel level{drawing.columns, drawing.rows, {}};
  level.rgba.resize(drawing.rgba.size());
  for (std::size_t n = 0; n < drawing.rgba.size() / 4; ++n) {
    const ColorSum& mean = means[n / static_cast<std::size_t>(drawing.columns)];
    const float rank = drawing.rgba[4 * n + 3];
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double share =
          rank < 1.0f ? clamped(static_cast<double>(drawing.rgba[4 * n + channel]), mean.rgb[channel]) /
                            std::max(mean.rgb[channel], 1e-6)
                      : 1.0;
      level.rgba[4 * n + channel] = static_cast<std::uint8_t>(
          std::lround(255.0 * std::clamp(share / static_cast<double>(kBrightest), 0.0, 1.0)));
    }
    level.rgba[4 * n + 3] = rank < 1.0f ? static_cast<std::uint8_t>(254.0f * rank) : kNoBlade;
  }
  return level;
}

StripLevel coarser_level(const StripLevel& fine) {
  StripLevel coarse{std::max(fine.columns / 2, 1), std::max(fine.rows / 2, 1), {}};
  coarse.rgba.resize(std::size_t{4} * coarse.columns * coarse.rows);
  Kernels kernels;
  for (int row = 0; row < coarse.rows; ++row) {
    for (int column = 0; column < coarse.columns; ++column) {
      const std::uint8_t* children[4];
      for (int n = 0; n < 4; ++n) {
        const int fine_column = std::min(2 * column + n % 2, fine.columns - 1);
        const int fine_row = std::min(2 * row + n / 2, fine.rows - 1);
        children[n] = &fine.rgba[4 * (static_cast<std::size_t>(fine_row) * fine.columns + fine_column)];
      }
      std::uint8_t* texel = &coarse.rgba[4 * (static_cast<std::size_t>(row) * coarse.columns + column)];
      for (int channel = 0; channel < 3; ++channel) {
        int sum = 0, blades = 0;
        for (const std::uint8_t* child : children) {
          if (child[3] == kNoBlade) continue;
          sum += child[channel];
          ++blades;
        }
        texel[channel] =
            blades > 0 ? static_cast<std::uint8_t>((sum + blades / 2) / blades) : children[0][channel];
      }
      const std::uint32_t chance = kernels.hash_u32(static_cast<std::uint32_t>(row) * 0x9e3779b9u +
                                                    static_cast<std::uint32_t>(column));
      texel[3] = children[chance >> 30][3];
    }
  }
  return coarse;
}

}  // namespace

float standing_share(const StripDrawing& drawing) {
  constexpr std::size_t kFewest =
      25;  // one texel in so many: what stands higher is not worth its empty fragments
  const auto texels = static_cast<std::size_t>(drawing.columns);
  for (std::size_t row = static_cast<std::size_t>(drawing.rows); row-- > 0;) {
    std::size_t blades = 0;
    for (std::size_t n = row * texels; n < (row + 1) * texels; ++n) blades += drawing.rgba[4 * n + 3] < 1.0f;
    if (kFewest * blades > texels) return static_cast<float>(row + 1) / static_cast<float>(drawing.rows);
  }
  return 0.0f;
}

std::vector<StripLevel> strip_levels(const StripDrawing& drawing) {
  std::vector<StripLevel> levels{finest_level(drawing)};
  while (levels.back().columns > 1 || levels.back().rows > 1) levels.push_back(coarser_level(levels.back()));
  return levels;
}

}  // namespace prairie
