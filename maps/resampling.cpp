#include "maps/resampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "maps/georaster/node_pixels.h"

namespace prairie {
namespace {

constexpr int kBlockNodes = 256;
constexpr int kPart = NodePixels::kBlockNodes;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Pixel coordinates of a block of nodes.
std::vector<glm::dvec2> pixels_of_block(const NodePixels& node_pixels, const NodeRect& block) {
  std::vector<glm::dvec2> result(static_cast<std::size_t>(block.columns) *
                                 static_cast<std::size_t>(block.rows));
  std::vector<glm::dvec2> part;
  for (int row = 0; row < block.rows; row += kPart) {
    for (int column = 0; column < block.columns; column += kPart) {
      const int columns = std::min(kPart, block.columns - column), rows = std::min(kPart, block.rows - row);
      part.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
      node_pixels.of_block(block.column + column, block.row + row, columns, rows, part);
      for (int j = 0; j < rows; ++j) {
        std::copy_n(part.begin() + static_cast<std::ptrdiff_t>(j) * columns, columns,
                    result.begin() + static_cast<std::ptrdiff_t>(row + j) * block.columns + column);
      }
    }
  }
  return result;
}

/// Moves a coordinate that is at most half a pixel outside onto the border; NaN if it is further.
double inside(double coordinate, int count) {
  constexpr double kHalf = 0.5 + 1e-6;
  if (!(coordinate >= -kHalf && coordinate <= count - 1 + kHalf))
    return std::numeric_limits<double>::quiet_NaN();
  return std::clamp(coordinate, 0.0, static_cast<double>(count - 1));
}

/// The pixels that a block needs; nothing where it needs none.
PixelRect window_of(std::span<glm::dvec2> pixels, const RasterPlace& place) {
  glm::dvec2 least(std::numeric_limits<double>::infinity()), most(-std::numeric_limits<double>::infinity());
  for (glm::dvec2& at : pixels) {
    at = {inside(at.x, place.columns), inside(at.y, place.rows)};
    if (std::isnan(at.x) || std::isnan(at.y)) continue;
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y)};
  }
  if (!(least.x <= most.x)) return {};
  const int left = static_cast<int>(std::floor(least.x)), top = static_cast<int>(std::floor(least.y));
  return {left, top, static_cast<int>(std::ceil(most.x)) - left + 1,
          static_cast<int>(std::ceil(most.y)) - top + 1};
}

/// Bilinear value of one channel in a window; weights of zero do not count, not even of no data.
float sample(std::span<const float> values, const PixelRect& window, int channels, int channel,
             glm::dvec2 at) {
  const double x = at.x - window.x, y = at.y - window.y;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const double u = x - i, v = y - j;
  double sum = 0.0;
  const auto add = [&](int column, int row, double weight) {
    if (weight == 0.0) return;
    sum += weight * static_cast<double>(
                        values[static_cast<std::size_t>((row * window.width + column) * channels + channel)]);
  };
  add(i, j, (1.0 - u) * (1.0 - v));
  add(i + 1, j, u * (1.0 - v));
  add(i, j + 1, (1.0 - u) * v);
  add(i + 1, j + 1, u * v);
  return static_cast<float>(sum);
}

}  // namespace

void resample(const MapPlacement& placement, int channels, const PixelWindow& window, MapSink& sink) {
  const MetricGrid& grid = placement.grid;
  const NodePixels node_pixels(placement.place, grid);
  std::vector<float> values;
  for (int row = 0; row < grid.rows; row += kBlockNodes) {
    for (int column = 0; column < grid.columns; column += kBlockNodes) {
      const NodeRect block{column, row, std::min(kBlockNodes, grid.columns - column),
                           std::min(kBlockNodes, grid.rows - row)};
      std::vector<glm::dvec2> pixels = pixels_of_block(node_pixels, block);
      values.assign(pixels.size() * static_cast<std::size_t>(channels), kNaN);
      const PixelRect needed = window_of(pixels, placement.place);
      if (needed.width > 0) {
        const std::vector<float> source = window(needed);
        for (std::size_t k = 0; k < pixels.size(); ++k) {
          if (std::isnan(pixels[k].x) || std::isnan(pixels[k].y)) continue;
          for (int channel = 0; channel < channels; ++channel) {
            values[k * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel)] =
                sample(source, needed, channels, channel, pixels[k]);
          }
        }
      }
      sink.take(block, values);
    }
  }
}

}  // namespace prairie
