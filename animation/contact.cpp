#include "animation/contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace prairie {
namespace {

constexpr int kSegments = 4;
constexpr int kPointsPerSegment = 8;  // of the drawn curve
constexpr int kRounds = 12;           // of rods, then of the curve
constexpr int kTurnsPerRod = 24;
constexpr double kMostTurnRad = 0.4;
constexpr double kAllowedDepthM = 0.5e-3;
constexpr double kLookCloserM = 20e-3;  // more than a curve can near an edge between two of its points
constexpr double kUnseenM = 2e-3;
constexpr double kMostStretched =
    1.25;  // a segment of a curve that is sharply bent, by its share of the length

glm::dquat rotation_of(glm::dvec3 vector) {
  const double angle = glm::length(vector);
  return angle > 1e-12 ? glm::angleAxis(angle, vector / angle) : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

glm::vec3 vector_of(glm::dquat q) {
  if (q.w < 0.0) q = -q;
  const glm::dvec3 v(q.x, q.y, q.z);
  const double s = glm::length(v);
  return glm::vec3(s > 1e-12 ? v * (2.0 * std::atan2(s, q.w) / s) : 2.0 * v);
}

/// The least rotation from one unit vector to another.
glm::dquat between(glm::dvec3 from, glm::dvec3 to) {
  const double c = glm::dot(from, to);
  if (c < -0.999999) {
    const glm::dvec3 aside = std::abs(from.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::angleAxis(3.14159265358979, glm::normalize(glm::cross(from, aside)));
  }
  const glm::dvec3 axis = glm::cross(from, to);
  return glm::normalize(glm::dquat(1.0 + c, axis.x, axis.y, axis.z));
}

/// Where a function with one minimum has it: golden section.
template <typename Function>
double least(double low, double high, const Function& function) {
  constexpr double kGolden = 0.6180339887498949;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = function(a), at_b = function(b);
  for (int n = 0; n < 16; ++n) {
    if (at_a < at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - kGolden * (high - low);
      at_a = function(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + kGolden * (high - low);
      at_b = function(b);
    }
  }
  return 0.5 * (low + high);
}

/// Where along a ray from `joint_m`, from `low_m` to `high_m`, a solid is nearest.
template <typename Shape>
double nearest_along_m(const Shape& solid, glm::dvec3 joint_m, glm::dvec3 t, double low_m, double high_m) {
  const auto distance_m = [&](double along_m) { return separation(solid, joint_m + t * along_m).distance_m; };
  const double nearest_m = least(low_m, high_m, distance_m);
  return distance_m(high_m) < distance_m(nearest_m) ? high_m : nearest_m;
}

double nearest_along_m(const Sphere& sphere, glm::dvec3 joint_m, glm::dvec3 t, double low_m, double high_m) {
  return std::clamp(glm::dot(sphere.centre_m - joint_m, t), low_m, high_m);
}

// How far a solid reaches along a unit vector.
double reach_m(const Sphere& sphere, glm::dvec3 n) {
  return glm::dot(n, sphere.centre_m) + sphere.radius_m;
}
double reach_m(const Capsule& capsule, glm::dvec3 n) {
  return std::max(glm::dot(n, capsule.from_m), glm::dot(n, capsule.to_m)) + capsule.radius_m;
}
double reach_m(const Box& box, glm::dvec3 n) {
  return glm::dot(n, box.centre_m) + glm::dot(glm::abs(n * box.axes), box.half_size_m);
}

/// Whether a plane across the outward direction of its nearer end parts a piece of curve from the solid: the
/// curve lies within the hull of its Bézier points.
template <typename Shape>
bool is_parted(const Shape& solid, const Kernels::BladeCurve& piece, double base_distance_m,
               double tip_distance_m) {
  const glm::dvec3 base_m(piece.base_m), tip_m(piece.tip_m);
  const glm::dvec3 n = separation(solid, base_distance_m < tip_distance_m ? base_m : tip_m).outward;
  const double least_m =
      std::min(std::min(glm::dot(n, base_m), glm::dot(n, base_m + glm::dvec3(piece.base_tangent_m) / 3.0)),
               std::min(glm::dot(n, tip_m), glm::dot(n, tip_m - glm::dvec3(piece.tip_tangent_m) / 3.0)));
  return least_m > reach_m(solid, n);
}

/// How deep the deepest point of each segment of the drawn curve is in the solid, at least 0.
template <typename Shape>
std::array<double, kSegments> depths_m(const Shape& solid, const Kernels::BladeChain& chain,
                                       double length_m) {
  const auto distance_m = [&](glm::vec3 point_m) {
    return separation(solid, glm::dvec3(point_m)).distance_m;
  };
  const std::array<double, kSegments + 1> at_joint_m = {distance_m(chain.p0), distance_m(chain.p1),
                                                        distance_m(chain.p2), distance_m(chain.p3),
                                                        distance_m(chain.p4)};
  std::array<double, kSegments> depth{};
  const double segment_m = 0.25 * kMostStretched * length_m;
  for (int i = 0; i < kSegments; ++i) {
    // No distance changes by more than the way.
    if (at_joint_m[i] + at_joint_m[i + 1] > segment_m) continue;
    const Kernels::BladeCurve piece = Kernels{}.chain_piece(chain, 0.25f * static_cast<float>(i) + 0.125f);
    if (is_parted(solid, piece, at_joint_m[i], at_joint_m[i + 1])) continue;
    const auto at_m = [&](double t) {
      return distance_m(Kernels{}.hermite_point(piece.base_m, piece.tip_m, piece.base_tangent_m,
                                                piece.tip_tangent_m, static_cast<float>(t)));
    };
    constexpr double kSpacing = 1.0 / kPointsPerSegment;
    double nearest = 0.0, least_m = 1e30;
    for (int n = i == 0 ? 1 : 0; n <= kPointsPerSegment; ++n) {
      const double here_m = at_m(n * kSpacing);
      if (here_m < least_m) {
        least_m = here_m;
        nearest = n * kSpacing;
      }
    }
    if (least_m < kLookCloserM) {
      const double t = least(std::max(nearest - kSpacing, 0.0), std::min(nearest + kSpacing, 1.0), at_m);
      least_m = std::min(least_m, at_m(t));
    }
    depth[i] = std::max(-least_m, 0.0);
  }
  return depth;
}

template <typename Shape>
class BentBlade {
 public:
  BentBlade(const Shape& solid, const Blade& blade, const Kernels::BladeCurve& rest, float growth,
            glm::dvec3 up, float least_rise, const ChainMotion& motion)
      : solid_(solid), blade_(blade), rest_(rest), growth_(growth), up_(up), least_rise_(least_rise) {
    const ChainVectors along = Kernels{}.chain_rest(rest).along;
    relaxed_ = {glm::dvec3(along.v1), glm::dvec3(along.v2), glm::dvec3(along.v3), glm::dvec3(along.v4)};
    turn_ = {rotation_of(glm::dvec3(motion.turn.v1)), rotation_of(glm::dvec3(motion.turn.v2)),
             rotation_of(glm::dvec3(motion.turn.v3)), rotation_of(glm::dvec3(motion.turn.v4))};
  }

  ChainVectors turns() const {
    return {vector_of(turn_[0]), vector_of(turn_[1]), vector_of(turn_[2]), vector_of(turn_[3])};
  }

  Kernels::BladeChain drawn() const {
    return Kernels{}.turned_chain_over(blade_, rest_, growth_, turns(), glm::vec3(up_), least_rise_);
  }

  /// Turns one rod after the other, with all above it, until each is as far from the solid as it should be.
  void clear(const std::array<double, kSegments>& margin_m) {
    const Kernels::BladeChain chain = drawn();
    const double rod_m = glm::distance(glm::dvec3(chain.p0), glm::dvec3(chain.p1));
    glm::dvec3 joint_m(chain.p0);
    for (int i = 0; i < kSegments; ++i) {
      clear_rod(i, joint_m, rod_m, margin_m[i]);
      joint_m += direction(i) * rod_m;
    }
  }

  /// Lays the blade on the ground, away from the solid.
  void lay_down() {
    const glm::dvec3 outward = separation(solid_, glm::dvec3(rest_.base_m)).outward;
    glm::dvec3 heading = on_ground(outward);
    if (glm::length(heading) < 0.1) heading = on_ground(direction(kSegments - 1));
    if (glm::length(heading) < 1e-3) heading = on_ground(glm::dvec3(1.0, 0.3, 0.0));
    heading = glm::normalize(heading);
    for (int i = 0; i < kSegments; ++i) turn_[i] = between(direction(i), heading) * turn_[i];
  }

 private:
  glm::dvec3 direction(int i) const { return turn_[i] * relaxed_[i]; }
  glm::dvec3 on_ground(glm::dvec3 v) const { return v - up_ * glm::dot(up_, v); }

  void point(int segment, glm::dvec3 to) {
    const glm::dquat by = between(direction(segment), glm::normalize(to));
    for (int i = segment; i < kSegments; ++i) turn_[i] = glm::normalize(by * turn_[i]);
  }

  void clear_rod(int segment, glm::dvec3 joint_m, double rod_m, double margin_m) {
    for (int n = 0; n < kTurnsPerRod; ++n) {
      const glm::dvec3 t = direction(segment);
      if (glm::dot(t, up_) < 0.0) point(segment, on_ground(t) + up_ * 1e-9);
      const auto [along_m, nearest] = nearest_on_rod(joint_m, direction(segment), rod_m);
      const double missing_m = margin_m - nearest.distance_m;
      if (missing_m <= 0.0) return;
      const double turn_rad = std::min((missing_m + 0.02e-3) / along_m, kMostTurnRad);
      glm::dvec3 aside = nearest.outward - direction(segment) * glm::dot(nearest.outward, direction(segment));
      if (glm::length(aside) < 1e-6)
        aside = glm::cross(direction(segment), up_ + glm::dvec3(1e-3, 2e-3, 0.0));
      // The outward direction is across the rod but for its ends, where a turn gains less.
      const double gain = std::max(glm::length(aside), 0.2);
      point(segment,
            direction(segment) + glm::normalize(aside) * std::tan(std::min(turn_rad / gain, kMostTurnRad)));
    }
  }

  /// A rod's own foot, which no turn moves, is left out.
  std::pair<double, Separation> nearest_on_rod(glm::dvec3 joint_m, glm::dvec3 t, double rod_m) const {
    const double nearest_m = nearest_along_m(solid_, joint_m, t, 0.05 * rod_m, rod_m);
    return {nearest_m, separation(solid_, joint_m + t * nearest_m)};
  }

  const Shape& solid_;
  const Blade& blade_;
  const Kernels::BladeCurve& rest_;
  float growth_;
  glm::dvec3 up_;
  float least_rise_;
  std::array<glm::dvec3, kSegments> relaxed_;
  std::array<glm::dquat, kSegments> turn_;
};

template <typename Shape>
bool bent_out_of(const Shape& solid, const Blade& blade, const Kernels::BladeCurve& rest, float growth,
                 glm::vec3 up, ChainMotion& motion, float least_rise) {
  const double length_m = static_cast<double>(blade.height_m * growth);
  const double root_m = separation(solid, glm::dvec3(rest.base_m)).distance_m;
  if (root_m > length_m * 1.05) return false;
  const bool is_under = root_m < kUnseenM;
  std::array<double, kSegments> depth_m{}, margin_m{};
  const auto deepest = [&] { return *std::max_element(depth_m.begin(), depth_m.end()); };
  if (!is_under) {
    // Most of those near a solid are clear of it.
    depth_m = depths_m(solid, Kernels{}.turned_chain_over(blade, rest, growth, motion.turn, up, least_rise),
                       length_m);
    if (deepest() <= kAllowedDepthM) return false;
  }
  BentBlade<Shape> bent(solid, blade, rest, growth, glm::normalize(glm::dvec3(up)), least_rise, motion);
  if (is_under) {
    bent.lay_down();
  } else {
    for (int round = 0; round < kRounds && deepest() > kAllowedDepthM; ++round) {
      bent.clear(margin_m);
      depth_m = depths_m(solid, bent.drawn(), length_m);
      for (int i = 0; i < kSegments; ++i) {
        if (depth_m[i] > kAllowedDepthM) margin_m[i] += depth_m[i];
      }
    }
  }
  motion.turn = bent.turns();
  motion.rate = ChainVectors{};
  return true;
}

}  // namespace

bool bend_out(const Solid& solid, const Blade& blade, const Kernels::BladeCurve& rest, float growth,
              glm::vec3 up, ChainMotion& motion, float least_rise) {
  return std::visit(
      [&](const auto& shape) { return bent_out_of(shape, blade, rest, growth, up, motion, least_rise); },
      solid);
}

}  // namespace prairie
