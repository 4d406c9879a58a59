// A smooth way through points in the plane: a centripetal Catmull-Rom spline (Yuksel et al. 2011, which has
// neither cusps nor loops between its points), measured along itself, so that what follows it goes at an even
// speed. All of it by +, ×, ÷ and √: the same everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace prairie {

/// A place on the way.
struct PathPlace {
  glm::dvec2 position_m{0.0};
  glm::dvec2 forward{1.0, 0.0};  // unit vector
};

class SmoothPath {
 public:
  /// Points nearer than this to the one before them are left out.
  static constexpr double kSamePointM = 1e-3;

  /// Needs two points that differ. `closed`: on from the last point to the first.
  SmoothPath(std::span<const glm::dvec2> points_m, bool closed);

  double length_m() const { return distances_m_.back(); }

  /// An open way ends at its ends; on a closed one `distance_m` may be any number.
  PathPlace at(double distance_m) const;

 private:
  using Cubic = std::array<glm::dvec2, 4>;  // powers of t, which goes from 0 to 1 along a span

  std::size_t spans() const { return points_m_.size() - (closed_ ? 0 : 1); }
  glm::dvec2 point(std::ptrdiff_t n) const;
  Cubic span(std::size_t n) const;

  bool closed_;
  std::vector<glm::dvec2> points_m_;
  std::vector<double> distances_m_;  // of the ends of pieces, several to a span
};

/// Whether two of the points differ enough to make a way.
bool has_length(std::span<const glm::dvec2> points_m);

}  // namespace prairie
