#include "pictures/picture_metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace prairie {
namespace {

constexpr glm::dvec3 kLuminanceWeights(0.2126, 0.7152, 0.0722);

[[maybe_unused]] bool holds(const LinearImage& image, const PixelRect& rect) {
  return image.rgb.size() ==
             3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) &&
         rect.x >= 0 && rect.y >= 0 && rect.width > 0 && rect.height > 0 &&
         rect.width <= image.width - rect.x && rect.height <= image.height - rect.y;
}

/// Means over the whole blocks of a rectangle, row by row.
struct BlockGrid {
  int columns = 0;
  int rows = 0;
  std::vector<double> luminances;
};

BlockGrid block_grid(const LinearImage& image, const PixelRect& rect, int block_px) {
  assert(block_px > 0);
  BlockGrid grid{rect.width / block_px, rect.height / block_px, {}};
  grid.luminances.reserve(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const PixelRect block{rect.x + column * block_px, rect.y + row * block_px, block_px, block_px};
      grid.luminances.push_back(glm::dot(kLuminanceWeights, mean_color(image, block)));
    }
  }
  return grid;
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

glm::dvec3 mean_color(const LinearImage& image, const PixelRect& rect) {
  assert(holds(image, rect));
  glm::dvec3 sum(0.0);
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    const std::size_t first = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                   static_cast<std::size_t>(rect.x));
    for (const float* pixel = &image.rgb[first]; pixel != &image.rgb[first] + 3 * rect.width; pixel += 3) {
      sum += glm::dvec3(pixel[0], pixel[1], pixel[2]);
    }
  }
  return sum / (static_cast<double>(rect.width) * static_cast<double>(rect.height));
}

double luminance_deviation(const LinearImage& image, const PixelRect& rect, int block_px) {
  const BlockGrid grid = block_grid(image, rect, block_px);
  assert(!grid.luminances.empty());
  const double count = static_cast<double>(grid.luminances.size());
  double mean = 0.0;
  for (const double luminance : grid.luminances) mean += luminance / count;

  // Columns and rows counted from the middle of the grid are uncorrelated over it, so each slope is found
  // alone.
  double xx = 0.0, yy = 0.0, x_luminance = 0.0, y_luminance = 0.0;
  const auto each_block = [&grid](auto&& visit) {
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        visit(column - 0.5 * (grid.columns - 1), row - 0.5 * (grid.rows - 1),
              grid.luminances[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                              static_cast<std::size_t>(column)]);
      }
    }
  };
  each_block([&](double x, double y, double luminance) {
    xx += x * x;
    yy += y * y;
    x_luminance += x * (luminance - mean);
    y_luminance += y * (luminance - mean);
  });
  const double x_slope = xx > 0.0 ? x_luminance / xx : 0.0;
  const double y_slope = yy > 0.0 ? y_luminance / yy : 0.0;
  double squares = 0.0;
  each_block([&](double x, double y, double luminance) {
    const double residual = luminance - mean - x_slope * x - y_slope * y;
    squares += residual * residual;
  });
  return std::sqrt(squares / count);
}

std::vector<double> block_luminances(const LinearImage& image, int block_px) {
  return block_grid(image, {0, 0, image.width, image.height}, block_px).luminances;
}

StepEvenness step_evenness(std::span<const std::vector<double>> frames) {
  assert(frames.size() >= 2);
  StepEvenness evenness;
  std::vector<double> changes;
  for (std::size_t step = 1; step < frames.size(); ++step) {
    assert(frames[step].size() == frames[0].size());
    double change = 0.0;
    for (std::size_t block = 0; block < frames[step].size(); ++block) {
      const double own = std::abs(frames[step][block] - frames[step - 1][block]);
      change = std::max(change, own);
      if (own > evenness.largest) {
        evenness.largest = own;
        evenness.largest_frame = step;
        evenness.largest_block = block;
      }
    }
    changes.push_back(change);
  }
  evenness.median = median_of(changes);
  if (evenness.largest > 0.0) {
    evenness.ratio =
        evenness.median > 0.0 ? evenness.largest / evenness.median : std::numeric_limits<double>::infinity();
  }
  return evenness;
}

}  // namespace prairie
