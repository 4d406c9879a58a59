// An exact oracle for the chain at rest (shaders/kernels/chain.glsl).
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

#include "shaders/kernels/kernels.h"

namespace prairie {

/// B11's chain in double, with frames that each segment hands on to the next, and equilibrium as the least
/// energy of springs and weight: no moments, no small rotations.
class EnergyChain {
 public:
  EnergyChain(const Blade& blade, const Kernels::BladeCurve& rest)
      : k_(static_cast<double>(blade.stiffness)), d_(glm::normalize(glm::dvec3(rest.base_tangent_m))) {
    const glm::dvec3 end = glm::normalize(glm::dvec3(rest.tip_tangent_m));
    axis_ = glm::dvec3(rest.side);
    const glm::dvec3 p = glm::cross(axis_, d_);
    turning_ = std::atan2(glm::dot(end, p), glm::dot(end, d_));
    settle();
  }
  using Vector = std::array<double, 12>;  // the rotation vectors of four springs
  std::array<glm::dvec3, 5> directions() const { return directions(springs_); }
  double residual() const {
    double most = 0.0;
    for (double g : gradient(springs_)) most = std::max(most, std::abs(g));
    return most;
  }

 private:
  static glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& rotation) {
    const double angle = glm::length(rotation);
    if (angle < 1e-12) return v + glm::cross(rotation, v);
    const glm::dvec3 a = rotation / angle;
    return v * std::cos(angle) + glm::cross(a, v) * std::sin(angle) +
           a * (glm::dot(a, v) * (1.0 - std::cos(angle)));
  }
  std::array<glm::dvec3, 5> directions(const Vector& x) const {
    glm::dmat3 frame(1.0);
    std::array<glm::dvec3, 5> result;
    for (int i = 0; i < 4; ++i) {
      const double rest = turning_ * (i == 0 ? 0.125 : 0.25);
      const glm::dvec3 psi(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
      glm::dmat3 next;
      for (int c = 0; c < 3; ++c) {
        glm::dvec3 unit(0.0);
        unit[c] = 1.0;
        next[c] = frame * rotated(rotated(unit, axis_ * rest), psi);
      }
      frame = next;
      result[i] = frame * d_;
    }
    result[4] = frame * rotated(d_, axis_ * (turning_ * 0.125));
    return result;
  }
  double energy(const Vector& x) const {
    double e = 0.0;
    for (int n = 0; n < 12; ++n) e += 0.5 * (n < 3 ? 2.0 : 1.0) * k_ * x[n] * x[n];
    const auto t = directions(x);
    for (int i = 0; i < 4; ++i) e += (7.0 - 2.0 * i) * t[i].z;
    return e;
  }
  Vector gradient(Vector x) const {
    Vector g;
    for (int n = 0; n < 12; ++n) {
      const double at = x[n], h = 1e-4;
      x[n] = at + h;
      const double up = energy(x);
      x[n] = at - h;
      g[n] = (up - energy(x)) / (2 * h);
      x[n] = at;
    }
    return g;
  }
  void settle() {
    double damping = 0.0;
    for (int step = 0; step < 200; ++step) {
      const Vector g = gradient(springs_);
      double most = 0;
      for (double v : g) most = std::max(most, std::abs(v));
      if (most < 1e-7) return;
      std::array<Vector, 12> h;
      for (int n = 0; n < 12; ++n) {
        Vector x = springs_;
        x[n] += 1e-4;
        const Vector up = gradient(x);
        x[n] -= 2e-4;
        const Vector down = gradient(x);
        for (int m = 0; m < 12; ++m) h[n][m] = (up[m] - down[m]) / 2e-4;
      }
      for (;;) {
        const auto [solved, x] = newton(h, g, damping);
        if (solved && energy(x) <= energy(springs_) + 1e-12) {
          springs_ = x;
          damping = damping < 0.1 ? 0.0 : damping * 0.3;
          break;
        }
        damping = std::max(2.0 * damping, 0.1);
        if (damping > 1e9) return;
      }
    }
  }
  // Cholesky's decomposition of h + damping.
  std::pair<bool, Vector> newton(std::array<Vector, 12> h, const Vector& g, double damping) const {
    Vector x = g;
    for (int n = 0; n < 12; ++n) {
      h[n][n] += damping;
      for (int m = 0; m < n; ++m) h[n][n] -= h[n][m] * h[n][m];
      if (h[n][n] <= 1e-9) return {false, x};
      h[n][n] = std::sqrt(h[n][n]);
      for (int r = n + 1; r < 12; ++r) {
        for (int m = 0; m < n; ++m) h[r][n] -= h[r][m] * h[n][m];
        h[r][n] /= h[n][n];
      }
    }
    for (int n = 0; n < 12; ++n) {
      for (int m = 0; m < n; ++m) x[n] -= h[n][m] * x[m];
      x[n] /= h[n][n];
    }
    for (int n = 11; n >= 0; --n) {
      for (int m = n + 1; m < 12; ++m) x[n] -= h[m][n] * x[m];
      x[n] /= h[n][n];
    }
    for (int n = 0; n < 12; ++n) x[n] = springs_[n] - x[n];
    return {true, x};
  }

  double k_;
  glm::dvec3 d_;
  glm::dvec3 axis_;
  double turning_ = 0.0;
  Vector springs_{};
};

}  // namespace prairie
