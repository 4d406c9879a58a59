// Separable convolution of one channel with filters that are even or odd about their middle, the border
// repeated. The sums are written in differences of pixels, so that a uniform region comes out exactly:
// unchanged by a smoothing filter, zero by a derivative. (FLIP takes the square root of derivatives, which
// would turn rounding into a visible error.)
#pragma once

#include <vector>

namespace prairie {

/// One channel of a picture: rows from the top.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// weights[k] is that of the pixel k + 1 steps ahead; the pixel k + 1 steps back has the same, or minus it if
/// odd.
struct EvenOddFilter {
  bool odd = false;
  float sum = 0.0f;  // of all weights
  std::vector<float> weights;
};

// `weights` are those of the pixels 0, 1, … steps ahead; at least two.

/// Even, scaled such that all weights sum to 1.
EvenOddFilter smoothing_filter(const std::vector<double>& weights);
/// Even, of weights that sum to 0 over both sides.
EvenOddFilter balanced_filter(const std::vector<double>& weights);
/// Odd; the weight in the middle must be 0.
EvenOddFilter antisymmetric_filter(const std::vector<double>& weights);

Plane filter_rows(const Plane& plane, const EvenOddFilter& filter);
Plane filter_columns(const Plane& plane, const EvenOddFilter& filter);

}  // namespace prairie
