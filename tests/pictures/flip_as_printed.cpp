#include "tests/pictures/flip_as_printed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace prairie {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;  // of rows

// Linear sRGB to XYZ and back, as CSS Color Module Level 4, section "Sample code for color conversions", has
// them.
constexpr Matrix kXyzFromRgb{{{0.41239079926595934, 0.357584339383878, 0.1804807884018343},
                              {0.21263900587151027, 0.715168678767756, 0.07219231536073371},
                              {0.01933081871559182, 0.11919477979462598, 0.9505321522496607}}};
constexpr Matrix kRgbFromXyz{{{3.2409699419045226, -1.537383177570094, -0.4986107602930034},
                              {-0.9692436362808796, 1.8759675015077202, 0.04155505740717559},
                              {0.05563007969699366, -0.20397695888897652, 1.0569715142428786}}};

Triple product(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t row = 0; row < 3; ++row)
    result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
  return result;
}

const Triple kWhite = product(kXyzFromRgb, {1.0, 1.0, 1.0});

Triple linear_rgb(const std::uint8_t* srgb) {
  Triple result{};
  for (std::size_t n = 0; n < 3; ++n) {
    const double v = srgb[n] / 255.0;
    result[n] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  return result;
}

Triple opponent_of_rgb(const Triple& rgb) {
  const Triple xyz = product(kXyzFromRgb, rgb);
  const double x = xyz[0] / kWhite[0], y = xyz[1] / kWhite[1], z = xyz[2] / kWhite[2];
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

Triple rgb_of_opponent(const Triple& color) {
  const double y = (color[0] + 16.0) / 116.0;
  return product(kRgbFromXyz,
                 {kWhite[0] * (y + color[1] / 500.0), kWhite[1] * y, kWhite[2] * (y - color[2] / 200.0)});
}

Triple hunt_lab_of_rgb(const Triple& rgb) {
  Triple xyz = product(kXyzFromRgb, rgb);
  for (std::size_t n = 0; n < 3; ++n) {
    const double t = xyz[n] / kWhite[n];
    xyz[n] = t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  }
  const double lightness = 116.0 * xyz[1] - 16.0;
  return {lightness, lightness / 100.0 * 500.0 * (xyz[0] - xyz[1]),
          lightness / 100.0 * 200.0 * (xyz[1] - xyz[2])};
}

double hyab(const Triple& one, const Triple& other) {
  return std::abs(one[0] - other[0]) + std::hypot(one[1] - other[1], one[2] - other[2]);
}

double color_error(const Triple& one, const Triple& other) {
  const double largest =
      std::pow(hyab(hunt_lab_of_rgb({0.0, 1.0, 0.0}), hunt_lab_of_rgb({0.0, 0.0, 1.0})), 0.7);
  const double error = std::pow(hyab(one, other), 0.7);
  const double pc = 0.4, pt = 0.95;
  if (error < pc * largest) return pt / (pc * largest) * error;
  return pt + (error - pc * largest) / (largest - pc * largest) * (1.0 - pt);
}

/// (2 radius + 1)² weights, row by row.
struct Kernel {
  int radius;
  std::vector<double> weights;
};

Kernel kernel(int radius, const std::function<double(int x, int y)>& weight) {
  Kernel result{radius, {}};
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) result.weights.push_back(weight(x, y));
  }
  return result;
}

/// Positive weights scaled to sum to 1, negative ones to −1.
Kernel normalized(Kernel kernel) {
  double positive = 0.0, negative = 0.0;
  for (const double w : kernel.weights) (w > 0.0 ? positive : negative) += std::abs(w);
  for (double& w : kernel.weights) {
    if (w != 0.0) w /= w > 0.0 ? positive : negative;
  }
  return kernel;
}

double convolved(const SrgbImage& image, const std::vector<double>& values, const Kernel& kernel, int x,
                 int y) {
  double sum = 0.0;
  std::size_t n = 0;
  for (int dy = -kernel.radius; dy <= kernel.radius; ++dy) {
    for (int dx = -kernel.radius; dx <= kernel.radius; ++dx) {
      const int column = std::clamp(x + dx, 0, image.width - 1),
                row = std::clamp(y + dy, 0, image.height - 1);
      sum += kernel.weights[n++] * values[static_cast<std::size_t>(row * image.width + column)];
    }
  }
  return sum;
}

struct SeenPixel {
  Triple hunt_lab;
  double edge, point;
};

std::vector<SeenPixel> see(const SrgbImage& image, double pixels_per_degree) {
  constexpr double kPi = std::numbers::pi;
  std::array<std::vector<double>, 3> opponent;
  std::vector<double> luminance;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const Triple color = opponent_of_rgb(linear_rgb(&image.rgb[i]));
    for (std::size_t n = 0; n < 3; ++n) opponent[n].push_back(color[n]);
    luminance.push_back((color[0] + 16.0) / 116.0);
  }

  const int csf_radius =
      static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * pixels_per_degree));
  const auto csf = [&](double a1, double b1, double a2, double b2) {
    return normalized(kernel(csf_radius, [&](int x, int y) {
      const double d2 = (x * x + y * y) / (pixels_per_degree * pixels_per_degree);
      return a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * d2 / b1) +
             a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * d2 / b2);
    }));
  };
  const std::array<Kernel, 3> csfs{csf(1.0, 0.0047, 0.0, 1e-5), csf(1.0, 0.0053, 0.0, 1e-5),
                                   csf(34.1, 0.04, 13.5, 0.025)};

  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  const auto gaussian = [&](int x, int y) {
    return std::exp(-(x * x + y * y) / (2.0 * deviation * deviation));
  };
  const auto edge = [&](int x, int y) { return -x * gaussian(x, y); };
  const auto point = [&](int x, int y) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x, y); };
  const Kernel edge_x = normalized(kernel(radius, edge));
  const Kernel edge_y = normalized(kernel(radius, [&](int x, int y) { return edge(y, x); }));
  const Kernel point_x = normalized(kernel(radius, point));
  const Kernel point_y = normalized(kernel(radius, [&](int x, int y) { return point(y, x); }));

  std::vector<SeenPixel> seen;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      Triple filtered{};
      for (std::size_t n = 0; n < 3; ++n) filtered[n] = convolved(image, opponent[n], csfs[n], x, y);
      Triple rgb = rgb_of_opponent(filtered);
      for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
      seen.push_back(
          {hunt_lab_of_rgb(rgb),
           std::hypot(convolved(image, luminance, edge_x, x, y), convolved(image, luminance, edge_y, x, y)),
           std::hypot(convolved(image, luminance, point_x, x, y),
                      convolved(image, luminance, point_y, x, y))});
    }
  }
  return seen;
}

}  // namespace

double flip_as_printed(const SrgbImage& reference, const SrgbImage& test, double pixels_per_degree,
                       FlipTerms terms) {
  const std::vector<SeenPixel> one = see(reference, pixels_per_degree), other = see(test, pixels_per_degree);
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double difference =
        std::max(std::abs(one[i].edge - other[i].edge), std::abs(one[i].point - other[i].point));
    const double feature_error =
        terms == FlipTerms::kColor ? 0.0 : std::sqrt(difference / std::numbers::sqrt2);
    sum += std::pow(color_error(one[i].hunt_lab, other[i].hunt_lab), 1.0 - feature_error);
  }
  return sum / static_cast<double>(one.size());
}

double uniform_flip_as_printed(const std::uint8_t (&reference)[3], const std::uint8_t (&test)[3]) {
  return color_error(hunt_lab_of_rgb(linear_rgb(reference)), hunt_lab_of_rgb(linear_rgb(test)));
}

}  // namespace prairie
