#include "app/viewer/fly_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "world/camera_placement.h"

namespace prairie {
namespace {

constexpr double kWalkingSpeedMPerS = 1.4;
constexpr double kFlyingSpeedMPerS = 6.0;
constexpr double kFastFactor = 5.0;
constexpr double kTurnRadPerPx = 0.003;
constexpr double kLargestPitchRad = glm::radians(89.0);  // short of the poles, where the view would flip
constexpr double kLowestFlightM = 0.15;
constexpr double kTallestWalkerM = 2.5;

double ground_m(const HeightField& ground, const Camera& camera) {
  return static_cast<double>(ground.height_m(glm::dvec2(camera.eye_m)));
}

}  // namespace

FlyCamera::FlyCamera(const Camera& start, const HeightField& ground) : camera_(start) {
  const double above_m = camera_.eye_m.z - ground_m(ground, camera_);
  walks_ = above_m > 0.0 && above_m <= kTallestWalkerM;
  eye_height_m_ = walks_ ? above_m : kEyeHeightM;
}

void FlyCamera::toggle_walking(const HeightField& ground) {
  walks_ = !walks_;
  if (walks_) eye_height_m_ = kEyeHeightM;
  settle(ground);
}

void FlyCamera::move(const Steering& steering, double dt_s, const HeightField& ground) {
  turn(steering);
  const glm::dvec3 level_forward{std::sin(camera_.yaw_rad), std::cos(camera_.yaw_rad), 0.0};
  const glm::dvec3 forward = walks_ ? level_forward : camera_.forward();
  const double up = walks_ ? 0.0 : steering.up;
  glm::dvec3 way = steering.forward * forward + steering.right * camera_.right() + glm::dvec3(0.0, 0.0, up);
  // Two keys at once are not faster than one.
  if (const double length = glm::length(way); length > 1.0) way /= length;
  const double speed_m_per_s =
      (walks_ ? kWalkingSpeedMPerS : kFlyingSpeedMPerS) * (steering.fast ? kFastFactor : 1.0);
  camera_.eye_m += way * speed_m_per_s * dt_s;
  settle(ground);
}

void FlyCamera::turn(const Steering& steering) {
  constexpr double kFullTurn = 2.0 * std::numbers::pi;
  camera_.yaw_rad = std::remainder(camera_.yaw_rad + steering.turn_right_px * kTurnRadPerPx, kFullTurn);
  camera_.pitch_rad = std::clamp(camera_.pitch_rad + steering.turn_up_px * kTurnRadPerPx, -kLargestPitchRad,
                                 kLargestPitchRad);
}

void FlyCamera::settle(const HeightField& ground) {
  const double below_m = ground_m(ground, camera_);
  camera_.eye_m.z = walks_ ? below_m + eye_height_m_ : std::max(camera_.eye_m.z, below_m + kLowestFlightM);
}

}  // namespace prairie
