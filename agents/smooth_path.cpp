#include "agents/smooth_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

namespace prairie {
namespace {

// Pieces of a span that are measured one by one.
constexpr std::size_t kPieces = 16;

bool differ(glm::dvec2 a_m, glm::dvec2 b_m) {
  return glm::length(a_m - b_m) > SmoothPath::kSamePointM;
}

std::vector<glm::dvec2> without_repeats(std::span<const glm::dvec2> points_m, bool closed) {
  std::vector<glm::dvec2> kept;
  for (const glm::dvec2 point_m : points_m) {
    if (kept.empty() || differ(point_m, kept.back())) kept.push_back(point_m);
  }
  while (closed && kept.size() > 2 && !differ(kept.back(), kept.front())) kept.pop_back();
  return kept;
}

glm::dvec2 position(const std::array<glm::dvec2, 4>& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

glm::dvec2 slope(const std::array<glm::dvec2, 4>& c, double t) {
  return c[1] + t * (2.0 * c[2] + 3.0 * t * c[3]);
}

/// ∫ |slope| dt by Gauss and Legendre's rule of three places.
double length_between(const std::array<glm::dvec2, 4>& c, double from, double to) {
  constexpr double kPlace = 0.7745966692414834;  // √(3/5)
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const double ends =
      glm::length(slope(c, middle - kPlace * half)) + glm::length(slope(c, middle + kPlace * half));
  return half / 9.0 * (8.0 * glm::length(slope(c, middle)) + 5.0 * ends);
}

/// Where the curve is `distance_m` beyond `from`, which is before `to`: Newton's steps, and halvings where
/// they lead out of what is left, as where the curve turns about.
double after(const std::array<glm::dvec2, 4>& c, double from, double to, double distance_m) {
  constexpr int kMostSteps = 24;
  constexpr double kNearM = 1e-9;
  double low = from, high = to;
  double t = from + (to - from) * std::min(distance_m / length_between(c, from, to), 1.0);
  for (int n = 0; n < kMostSteps; ++n) {
    const double beyond_m = length_between(c, from, t) - distance_m;
    if (std::abs(beyond_m) < kNearM) break;
    (beyond_m > 0.0 ? high : low) = t;
    const double next = t - beyond_m / glm::length(slope(c, t));
    t = next > low && next < high ? next : 0.5 * (low + high);  // NaN goes to the middle
  }
  return t;
}

/// Unit vector along the curve; where it stands still, as at the end of a way that leads back, that of a
/// place close by.
glm::dvec2 forward_at(const std::array<glm::dvec2, 4>& c, double t) {
  constexpr double kAside = 1e-3;
  constexpr double kStandsM = 1e-6;
  glm::dvec2 way_m = slope(c, t);
  if (glm::length(way_m) < kStandsM) way_m = slope(c, t < 0.5 ? t + kAside : t - kAside);
  return way_m / glm::length(way_m);
}

}  // namespace

bool has_length(std::span<const glm::dvec2> points_m) {
  return std::any_of(points_m.begin(), points_m.end(),
                     [&](glm::dvec2 point_m) { return differ(point_m, points_m.front()); });
}

SmoothPath::SmoothPath(std::span<const glm::dvec2> points_m, bool closed)
    : closed_(closed), points_m_(without_repeats(points_m, closed)) {
  assert(points_m_.size() >= 2);
  distances_m_.reserve(spans() * kPieces + 1);
  distances_m_.push_back(0.0);
  for (std::size_t n = 0; n < spans(); ++n) {
    const Cubic c = span(n);
    for (std::size_t piece = 0; piece < kPieces; ++piece) {
      const double from = static_cast<double>(piece) / kPieces, to = static_cast<double>(piece + 1) / kPieces;
      distances_m_.push_back(distances_m_.back() + length_between(c, from, to));
    }
  }
}

glm::dvec2 SmoothPath::point(std::ptrdiff_t n) const {
  const auto count = static_cast<std::ptrdiff_t>(points_m_.size());
  const auto given = [&](std::ptrdiff_t k) { return points_m_[static_cast<std::size_t>(k)]; };
  if (closed_) return given((n + count) % count);
  // Beyond its ends an open way would go straight on.
  if (n < 0) return 2.0 * given(0) - given(1);
  if (n >= count) return 2.0 * given(count - 1) - given(count - 2);
  return given(n);
}

SmoothPath::Cubic SmoothPath::span(std::size_t n) const {
  const auto first = static_cast<std::ptrdiff_t>(n);
  const glm::dvec2 before = point(first - 1), from = point(first), to = point(first + 1),
                   behind = point(first + 2);
  // Knots lie the square roots of distances apart: that is what "centripetal" means.
  const auto interval = [](glm::dvec2 a, glm::dvec2 b) { return std::sqrt(glm::length(b - a)); };
  const double d0 = interval(before, from), d1 = interval(from, to), d2 = interval(to, behind);
  const glm::dvec2 leave = d1 * ((from - before) / d0 - (to - before) / (d0 + d1)) + (to - from);
  const glm::dvec2 arrive = (to - from) + d1 * ((behind - to) / d2 - (behind - from) / (d1 + d2));
  return {from, leave, 3.0 * (to - from) - 2.0 * leave - arrive, 2.0 * (from - to) + leave + arrive};
}

PathPlace SmoothPath::at(double distance_m) const {
  if (closed_) distance_m -= length_m() * std::floor(distance_m / length_m());
  distance_m = std::clamp(distance_m, 0.0, length_m());
  // The piece that holds it; its end is the first beyond, or the last there is.
  const auto end = std::upper_bound(distances_m_.begin() + 1, distances_m_.end() - 1, distance_m);
  const auto piece = static_cast<std::size_t>(end - distances_m_.begin()) - 1;
  const Cubic c = span(piece / kPieces);
  const double from = static_cast<double>(piece % kPieces) / kPieces;
  const double t = after(c, from, from + 1.0 / kPieces, distance_m - distances_m_[piece]);
  return {position(c, t), forward_at(c, t)};
}

}  // namespace prairie
