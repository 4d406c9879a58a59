#include "pictures/flip.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "pictures/even_odd_filter.h"
#include "pictures/srgb.h"

namespace prairie {
namespace {

// Colour spaces.

/// XYZ of a colour of luminance 1 and chromaticity (x, y).
glm::dvec3 xyz_of_chromaticity(double x, double y) {
  return {x / y, 1.0, (1.0 - x - y) / y};
}

/// From linear RGB to XYZ relative to white, (X/Xn, Y/Yn, Z/Zn), by the primaries and the white D65 of IEC
/// 61966-2-1.
glm::dmat3 relative_xyz_from_rgb() {
  const glm::dvec3 white = xyz_of_chromaticity(0.3127, 0.3290);
  const glm::dmat3 primaries(xyz_of_chromaticity(0.64, 0.33), xyz_of_chromaticity(0.30, 0.60),
                             xyz_of_chromaticity(0.15, 0.06));
  const glm::dvec3 amounts = glm::inverse(primaries) * white;
  glm::dmat3 result;
  for (int channel = 0; channel < 3; ++channel)
    result[channel] = primaries[channel] * amounts[channel] / white;
  return result;
}

/// From relative XYZ to (Y, Cx, Cz) = (116 Y/Yn − 16, 500 (X/Xn − Y/Yn), 200 (Y/Yn − Z/Zn)), without the −16.
const glm::dmat3 kOpponentFromRelativeXyz(0.0, 500.0, 0.0, 116.0, -500.0, 200.0, 0.0, 0.0, -200.0);
constexpr float kOpponentBlack = -16.0f;

/// CIELab with both chromatic axes scaled by L*/100: the less light, the less colourful (the Hunt effect).
glm::vec3 hunt_lab_of_relative_xyz(const glm::vec3& xyz) {
  constexpr float kDelta = 6.0f / 29.0f;
  const auto f = [](float t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
  };
  const float y = f(xyz.y);
  const float lightness = 116.0f * y - 16.0f;
  return {lightness, 0.01f * lightness * 500.0f * (f(xyz.x) - y),
          0.01f * lightness * 200.0f * (y - f(xyz.z))};
}

/// Between two colours in (Hunt-adjusted) CIELab (Abasi, Amani Tehran and Fairchild 2020).
float hyab_distance(const glm::vec3& one, const glm::vec3& other) {
  const glm::vec3 d = one - other;
  return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// The filters of the colour pipeline and of the feature pipeline.

/// One Gaussian of a contrast sensitivity function, g(x) = a √(π/b) exp(−π² x²/b), x in degrees.
struct SensitivityTerm {
  double a;
  double b;
};
using Sensitivity = std::array<SensitivityTerm, 2>;
constexpr double kWidestB = 0.04;
// Of the channels Y, Cx (red to green), Cz (blue to yellow).
constexpr std::array<Sensitivity, 3> kSensitivities{{{{{1.0, 0.0047}, {0.0, 0.0047}}},
                                                     {{{1.0, 0.0053}, {0.0, 0.0053}}},
                                                     {{{34.1, kWidestB}, {13.5, 0.025}}}}};

constexpr double kFeatureWidthDegrees = 0.082;  // w, from peak to trough of the eye's edge detector

std::vector<double> gaussian_weights(double deviation_px, int radius) {
  std::vector<double> weights;
  for (int k = 0; k <= radius; ++k) weights.push_back(std::exp(-0.5 * k * k / (deviation_px * deviation_px)));
  return weights;
}

double sum_on_both_sides(const std::vector<double>& weights) {
  double sum = weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) sum += 2.0 * weights[k];
  return sum;
}

/// What the eye resolves of one opponent channel: the channel filtered with a sum of two Gaussians of total
/// weight 1.
Plane resolved(const Plane& channel, const Sensitivity& sensitivity, double pixels_per_degree) {
  const auto deviation_px = [&](double b) {
    return std::sqrt(0.5 * b) / std::numbers::pi * pixels_per_degree;
  };
  const int radius = static_cast<int>(std::ceil(3.0 * deviation_px(kWidestB)));
  std::array<std::vector<double>, 2> gaussians;
  std::array<double, 2> volumes{};  // under each of the two, over the plane
  for (std::size_t n = 0; n < 2; ++n) {
    const SensitivityTerm& term = sensitivity[n];
    gaussians[n] = gaussian_weights(deviation_px(term.b), radius);
    const double sum = sum_on_both_sides(gaussians[n]);
    volumes[n] = term.a * std::sqrt(std::numbers::pi / term.b) * sum * sum;
  }
  const EvenOddFilter first = smoothing_filter(gaussians[0]);
  Plane result = filter_columns(filter_rows(channel, first), first);
  if (volumes[1] == 0.0) return result;
  const EvenOddFilter second = smoothing_filter(gaussians[1]);
  const Plane other = filter_columns(filter_rows(channel, second), second);
  const float share = static_cast<float>(volumes[1] / (volumes[0] + volumes[1]));
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    result.values[i] += share * (other.values[i] - result.values[i]);
  }
  return result;
}

struct Features {
  Plane edges;   // magnitude of the gradient
  Plane points;  // magnitude of the two second derivatives
};

Plane magnitude(Plane x, const Plane& y) {
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    x.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
  }
  return x;
}

/// Edges and points of relative luminance Y/Yn: its first and second derivatives, each through a Gaussian and
/// scaled such that the positive weights sum to 1 and the negative ones to −1.
Features detect_features(const Plane& luminance, double pixels_per_degree) {
  const double deviation_px = 0.5 * kFeatureWidthDegrees * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation_px));
  const std::vector<double> gaussian = gaussian_weights(deviation_px, radius);
  std::vector<double> first = gaussian, second = gaussian;
  double first_sum = 0.0, positive_sum = 0.0;
  for (int k = 0; k <= radius; ++k) {
    const std::size_t n = static_cast<std::size_t>(k);
    first[n] *= k;
    second[n] *= k * k / (deviation_px * deviation_px) - 1.0;
    first_sum += first[n];
    positive_sum += 2.0 * std::max(second[n], 0.0);
  }
  const double negative_sum = positive_sum - sum_on_both_sides(second);
  for (double& weight : first) weight /= first_sum;
  for (double& weight : second) weight /= weight > 0.0 ? positive_sum : negative_sum;

  const EvenOddFilter smooth = smoothing_filter(gaussian);
  const EvenOddFilter edge = antisymmetric_filter(first);
  const EvenOddFilter point = balanced_filter(second);
  const Plane smooth_rows = filter_rows(luminance, smooth);
  return {
      magnitude(filter_columns(filter_rows(luminance, edge), smooth), filter_columns(smooth_rows, edge)),
      magnitude(filter_columns(filter_rows(luminance, point), smooth), filter_columns(smooth_rows, point))};
}

// One picture as it is seen.

struct Seen {
  std::vector<glm::vec3> hunt_lab;
  Features features;
};

Seen see(const SrgbImage& image, double pixels_per_degree) {
  std::array<float, 256> linear{};
  for (std::size_t byte = 0; byte < 256; ++byte) {
    linear[byte] = static_cast<float>(linear_from_srgb(static_cast<double>(byte) / 255.0));
  }
  const glm::dmat3 xyz_from_rgb = relative_xyz_from_rgb();
  const glm::mat3 opponent_from_rgb(kOpponentFromRelativeXyz * xyz_from_rgb);
  const glm::mat3 rgb_from_opponent(glm::inverse(kOpponentFromRelativeXyz * xyz_from_rgb));
  const glm::mat3 relative_xyz(xyz_from_rgb);

  Plane blank{image.width, image.height, std::vector<float>(image.rgb.size() / 3)};
  std::array<Plane, 3> opponent{blank, blank, blank};
  Plane luminance = std::move(blank);
  for (std::size_t i = 0; i < luminance.values.size(); ++i) {
    const glm::vec3 rgb(linear[image.rgb[3 * i]], linear[image.rgb[3 * i + 1]], linear[image.rgb[3 * i + 2]]);
    const glm::vec3 color = opponent_from_rgb * rgb;
    opponent[0].values[i] = color.x + kOpponentBlack;
    opponent[1].values[i] = color.y;
    opponent[2].values[i] = color.z;
    luminance.values[i] = color.x / 116.0f;
  }

  Seen seen{{}, detect_features(luminance, pixels_per_degree)};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    opponent[channel] = resolved(opponent[channel], kSensitivities[channel], pixels_per_degree);
  }
  seen.hunt_lab.resize(luminance.values.size());
  const std::size_t width = static_cast<std::size_t>(image.width);
  oneapi::tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(image.height), [&](std::size_t row) {
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      const glm::vec3 color(opponent[0].values[i] - kOpponentBlack, opponent[1].values[i],
                            opponent[2].values[i]);
      const glm::vec3 rgb = glm::clamp(rgb_from_opponent * color, 0.0f, 1.0f);
      seen.hunt_lab[i] = hunt_lab_of_relative_xyz(relative_xyz * rgb);
    }
  });
  return seen;
}

// Differences between two.

constexpr float kColorExponent = 0.7f;    // q_c
constexpr float kFeatureExponent = 0.5f;  // q_f

/// A colour difference raised to q_c, brought to 0…1: those below p_c = 0.4 of the largest get 0…p_t = 0.95,
/// the large ones, of which the eye no longer judges how large they are, share the rest.
float redistributed(float difference, float largest) {
  constexpr float kShare = 0.95f;
  const float knee = 0.4f * largest;
  return difference < knee ? kShare * difference / knee
                           : kShare + (1.0f - kShare) * (difference - knee) / (largest - knee);
}

/// The largest difference within sRGB, that between its green and its blue.
float largest_color_difference() {
  const glm::mat3 xyz_from_rgb(relative_xyz_from_rgb());
  return std::pow(
      hyab_distance(hunt_lab_of_relative_xyz(xyz_from_rgb[1]), hunt_lab_of_relative_xyz(xyz_from_rgb[2])),
      kColorExponent);
}

}  // namespace

double mean_flip(const SrgbImage& reference, const SrgbImage& test, double pixels_per_degree) {
  assert(reference.width == test.width && reference.height == test.height && !reference.rgb.empty());
  assert(reference.rgb.size() ==
         3 * static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height));
  assert(test.rgb.size() == reference.rgb.size() && pixels_per_degree >= 1.0);
  const Seen one = see(reference, pixels_per_degree);
  const Seen other = see(test, pixels_per_degree);
  const float largest = largest_color_difference();

  const std::size_t width = static_cast<std::size_t>(reference.width);
  std::vector<double> row_sums(static_cast<std::size_t>(reference.height));
  oneapi::tbb::parallel_for(std::size_t{0}, row_sums.size(), [&](std::size_t row) {
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      const float distance = hyab_distance(one.hunt_lab[i], other.hunt_lab[i]);
      const float color = redistributed(std::pow(distance, kColorExponent), largest);
      const float edge = std::abs(one.features.edges.values[i] - other.features.edges.values[i]);
      const float point = std::abs(one.features.points.values[i] - other.features.points.values[i]);
      const float feature = std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, kFeatureExponent);
      row_sums[row] += static_cast<double>(std::pow(color, 1.0f - feature));
    }
  });
  // In the order of the rows, so that the rounding is the same whoever summed them.
  double sum = 0.0;
  for (const double row_sum : row_sums) sum += row_sum;
  return sum / static_cast<double>(one.hunt_lab.size());
}

}  // namespace prairie
