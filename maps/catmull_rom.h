// Weights of the cubic Catmull–Rom spline between the middle two of four nodes, and of its derivative. The
// spline passes through its nodes and is once continuously differentiable.
#pragma once

#include <array>

namespace prairie {

/// t ∈ [0, 1]: from the second node to the third. The weights sum to 1; at t = 0 they are exactly (0, 1, 0,
/// 0).
constexpr std::array<double, 4> catmull_rom(double t) {
  return {0.5 * t * ((2.0 - t) * t - 1.0), 1.0 + 0.5 * t * t * (3.0 * t - 5.0),
          0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

/// d/dt of the above; the weights sum to 0.
constexpr std::array<double, 4> catmull_rom_slope(double t) {
  return {0.5 * (t * (4.0 - 3.0 * t) - 1.0), 0.5 * t * (9.0 * t - 10.0), 0.5 * (1.0 + t * (8.0 - 9.0 * t)),
          0.5 * t * (3.0 * t - 2.0)};
}

/// Largest sum of the weights' magnitudes over a square patch (1.25² at its middle): by how much the surface
/// can leave the range of its 4 × 4 nodes, measured from the middle of that range.
inline constexpr float kCatmullRomOvershoot = 1.5625f;

}  // namespace prairie
