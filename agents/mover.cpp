#include "agents/mover.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "agents/plane_vectors.h"
#include "animation/heading.h"
#include "animation/range_check.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr std::size_t kMostPoints = 10'000;
constexpr double kFarthestM = 1e6;
constexpr double kTurnsPerRad = 0.15915494309189535;

// A stone presses where it sinks into the sward, not with all of its width.
constexpr double kStonesContact = 0.6;
constexpr double kStonesWeight = 1.5;
constexpr double kLeastTreadM = 0.01, kMostTreadM = 5.0;

// A cart of half width 1.
constexpr glm::dvec3 kBoxHalfSize(1.6, 1.0, 0.45);
constexpr double kWheelRadius = 0.35;
constexpr double kWheelHalfAxle = 0.06;                                // of the capsule's axis
constexpr glm::dvec2 kWheelPlace(kBoxHalfSize.x - kWheelRadius, 1.0);  // from the middle to a wheel's
constexpr double kBoxRise = kWheelRadius + kBoxHalfSize.z;             // its floor lies at the wheels' axles

constexpr std::array<glm::dvec2, 4> kCorners = {glm::dvec2(1.0, 1.0), glm::dvec2(1.0, -1.0),
                                                glm::dvec2(-1.0, 1.0), glm::dvec2(-1.0, -1.0)};

const MoverPath& checked(const MoverPath& mover) {
  check(mover);
  return mover;
}

/// Unit columns forward, left, up, on ground that rises by `slope` (∂z/∂x, ∂z/∂y).
glm::dmat3 axes_on(glm::dvec2 slope, glm::dvec2 forward) {
  const glm::dvec3 up = glm::normalize(glm::dvec3(-slope, 1.0));
  const glm::dvec3 ahead = glm::normalize(glm::dvec3(forward, glm::dot(slope, forward)));
  return {ahead, glm::cross(up, ahead), up};
}

/// The middles of a cart's wheels.
std::array<glm::dvec3, 4> wheels_of(double half_width_m, const MoverPlace& place) {
  std::array<glm::dvec3, 4> wheels_m;
  for (std::size_t n = 0; n < kCorners.size(); ++n) {
    const glm::dvec3 from_middle(kCorners[n] * kWheelPlace, -kBoxHalfSize.z);
    wheels_m[n] = place.centre_m + place.axes * (half_width_m * from_middle);
  }
  return wheels_m;
}

/// Below the lowest place of a wheel.
glm::dvec2 print_of(double half_width_m, const MoverPlace& place, glm::dvec3 wheel_m) {
  return glm::dvec2(wheel_m - kWheelRadius * half_width_m * place.axes[2]);
}

}  // namespace

void check(const MoverPath& mover) {
  check_range("radius_m", mover.radius_m, 0.05, 3.0);
  check_range("speed_m_per_s", mover.speed_m_per_s, 0.0, 20.0);
  check_range("start_s", mover.start_s, -1e9, 1e9);
  if (mover.path_m.size() > kMostPoints) {
    throw BadInput("", "path_m", fmt::format("{} points", mover.path_m.size()),
                   fmt::format("at most {}", kMostPoints));
  }
  for (const glm::dvec2 point_m : mover.path_m) {
    check_range("path_m", point_m.x, -kFarthestM, kFarthestM);
    check_range("path_m", point_m.y, -kFarthestM, kFarthestM);
  }
  if (!has_length(mover.path_m))
    throw BadInput("", "path_m", "no two places", "points at least a millimetre apart");
}

Mover::Mover(MoverPath path) : path_(checked(path)), way_(path_.path_m, path_.loops) {}

MoverPlace Mover::place(const HeightField& ground, double time_s) const {
  const double rolled_m = path_.speed_m_per_s * std::max(time_s - path_.start_s, 0.0);
  const double way_m = path_.loops ? rolled_m : std::min(rolled_m, way_.length_m());
  const PathPlace at = way_.at(way_m);
  if (path_.kind == MoverKind::kStone)
    return stone_place(ground, path_.radius_m, at.position_m, at.forward, way_m);
  return cart_place(ground, path_.radius_m, at.position_m, at.forward);
}

// Rolled about the axis to the left, on the ground's slope, without slipping along a level way; being seen
// from above, the way up a slope is a little shorter than what the stone rolls over.
MoverPlace stone_place(const HeightField& ground, double radius_m, glm::dvec2 contact_m, glm::dvec2 forward,
                       double rolled_m) {
  const glm::dmat3 rest = axes_on(glm::dvec2(ground.slope(contact_m)), forward);
  const glm::dvec3 on_ground_m(contact_m, static_cast<double>(ground.height_m(contact_m)));
  const double turns = rolled_m / radius_m * kTurnsPerRad;
  const double sine = sine_of_turns(turns), cosine = sine_of_turns(turns + 0.25);
  // The kernels' sine is good to 4e-7; a mean over both keeps the columns unit vectors.
  const double length = std::sqrt(sine * sine + cosine * cosine);
  const double s = sine / length, c = cosine / length;
  const glm::dmat3 axes(c * rest[0] - s * rest[2], rest[1], s * rest[0] + c * rest[2]);
  return {on_ground_m + radius_m * rest[2], axes, contact_m, forward};
}

// On the plane that fits best the ground below its four wheels.
MoverPlace cart_place(const HeightField& ground, double half_width_m, glm::dvec2 contact_m,
                      glm::dvec2 forward) {
  const glm::dvec2 wheel_m = half_width_m * kWheelPlace;
  const glm::dvec2 left = left_of(forward);
  double mean_m = 0.0, rise = 0.0, roll = 0.0;  // along the way and to its left, per metre
  for (const glm::dvec2 corner : kCorners) {
    const glm::dvec2 at_m = contact_m + corner.x * wheel_m.x * forward + corner.y * wheel_m.y * left;
    const double z_m = static_cast<double>(ground.height_m(at_m));
    mean_m += 0.25 * z_m;
    rise += 0.25 * corner.x * z_m / wheel_m.x;
    roll += 0.25 * corner.y * z_m / wheel_m.y;
  }
  const glm::dmat3 axes = axes_on(rise * forward + roll * left, forward);
  return {glm::dvec3(contact_m, mean_m) + kBoxRise * half_width_m * axes[2], axes, contact_m, forward};
}

double cart_wheelbase_m(double half_width_m) {
  return 2.0 * kWheelPlace.x * half_width_m;
}

std::vector<Solid> solids_of(MoverKind kind, double radius_m, const MoverPlace& place) {
  if (kind == MoverKind::kStone) return {Sphere{place.centre_m, radius_m}};
  std::vector<Solid> solids{Box{place.centre_m, place.axes, radius_m * kBoxHalfSize}};
  const glm::dvec3 half_axle_m = kWheelHalfAxle * radius_m * place.axes[1];
  for (const glm::dvec3 wheel_m : wheels_of(radius_m, place))
    solids.push_back(Capsule{wheel_m - half_axle_m, wheel_m + half_axle_m, kWheelRadius * radius_m});
  return solids;
}

std::vector<TreadStep> tread_steps(MoverKind kind, double radius_m, const MoverPlace& from,
                                   const MoverPlace& to, std::uint32_t first_id) {
  if (kind == MoverKind::kStone) {
    const double tread_m = std::clamp(kStonesContact * radius_m, kLeastTreadM, kMostTreadM);
    return {{first_id, from.contact_m, to.contact_m, tread_m, kStonesWeight}};
  }
  std::vector<TreadStep> steps;
  const std::array<glm::dvec3, 4> from_m = wheels_of(radius_m, from), to_m = wheels_of(radius_m, to);
  const double tread_m = 0.12 * radius_m + 0.03;
  for (std::uint32_t n = 0; n < kTreadIdsPerMover; ++n)
    steps.push_back(
        {first_id + n, print_of(radius_m, from, from_m[n]), print_of(radius_m, to, to_m[n]), tread_m, 1.0});
  return steps;
}

}  // namespace prairie
