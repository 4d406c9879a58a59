#include "pictures/even_odd_filter.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace prairie {
namespace {

/// One row of results; `pixels(k)` points to the row of pixels k steps ahead (back, if negative) of these.
template <typename Pixels>
void filter_row(const EvenOddFilter& filter, int width, const Pixels& pixels, float* out) {
  const float* middle = pixels(0);
  const float sum = filter.sum;
  for (int x = 0; x < width; ++x) out[x] = sum * middle[x];
  for (int k = 1; k <= static_cast<int>(filter.weights.size()); ++k) {
    const float weight = filter.weights[static_cast<std::size_t>(k - 1)];
    const float* ahead = pixels(k);
    const float* back = pixels(-k);
    if (filter.odd) {
      for (int x = 0; x < width; ++x) out[x] += weight * (ahead[x] - back[x]);
    } else {
      for (int x = 0; x < width; ++x) out[x] += weight * ((ahead[x] - middle[x]) + (back[x] - middle[x]));
    }
  }
}

EvenOddFilter filter_of(bool odd, float sum, const std::vector<double>& weights, double scale) {
  assert(weights.size() >= 2);
  EvenOddFilter filter{odd, sum, {}};
  for (std::size_t k = 1; k < weights.size(); ++k) {
    filter.weights.push_back(static_cast<float>(scale * weights[k]));
  }
  return filter;
}

}  // namespace

EvenOddFilter smoothing_filter(const std::vector<double>& weights) {
  double sum = weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) sum += 2.0 * weights[k];
  return filter_of(false, 1.0f, weights, 1.0 / sum);
}

EvenOddFilter balanced_filter(const std::vector<double>& weights) {
  return filter_of(false, 0.0f, weights, 1.0);
}

EvenOddFilter antisymmetric_filter(const std::vector<double>& weights) {
  assert(weights[0] == 0.0);
  return filter_of(true, 0.0f, weights, 1.0);
}

Plane filter_rows(const Plane& plane, const EvenOddFilter& filter) {
  Plane result{plane.width, plane.height, std::vector<float>(plane.values.size())};
  const std::ptrdiff_t width = plane.width;
  const std::ptrdiff_t radius = static_cast<std::ptrdiff_t>(filter.weights.size());
  oneapi::tbb::parallel_for(std::ptrdiff_t{0}, std::ptrdiff_t{plane.height}, [&](std::ptrdiff_t y) {
    const float* row = plane.values.data() + y * width;
    std::vector<float> padded(static_cast<std::size_t>(width + 2 * radius));
    for (std::ptrdiff_t x = 0; x < width + 2 * radius; ++x) {
      padded[static_cast<std::size_t>(x)] = row[std::clamp(x - radius, std::ptrdiff_t{0}, width - 1)];
    }
    const float* middle = padded.data() + radius;
    filter_row(
        filter, plane.width, [middle](int k) { return middle + k; }, result.values.data() + y * width);
  });
  return result;
}

Plane filter_columns(const Plane& plane, const EvenOddFilter& filter) {
  Plane result{plane.width, plane.height, std::vector<float>(plane.values.size())};
  const std::ptrdiff_t width = plane.width;
  oneapi::tbb::parallel_for(0, plane.height, [&](int y) {
    const auto row = [&](int k) {
      return plane.values.data() + std::clamp(y + k, 0, plane.height - 1) * width;
    };
    filter_row(filter, plane.width, row, result.values.data() + y * width);
  });
  return result;
}

}  // namespace prairie
