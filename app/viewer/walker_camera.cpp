#include "app/viewer/walker_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "world/world.h"

namespace prairie {
namespace {

constexpr double kChestOfHeight = 0.7;
constexpr double kFirstDistanceM = 4.5;
constexpr double kNearestM = 1.0, kFarthestM = 80.0;
constexpr double kPerNotch = 0.15;  // of the distance, e-fold
constexpr double kPerSecond = 1.0;  // the same, while a key is held
constexpr double kFollowPitchRad = glm::radians(-16.0);
constexpr double kHighestPitchRad = glm::radians(40.0), kLowestPitchRad = glm::radians(-85.0);
constexpr double kTurnRadPerPx = 0.003;
constexpr double kTargetTimeS = 0.15, kHeadingTimeS = 0.6, kDistanceTimeS = 0.25;
constexpr double kLowestEyeM = 0.3;

double height_m(const HeightField& ground, glm::dvec2 place_m) {
  return static_cast<double>(ground.height_m(place_m));
}

double from_half_turn(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

glm::dvec3 chest_m(const World& world, std::size_t walker) {
  const glm::dvec2 place_m = world.walkers()[walker].position_m;
  return {place_m,
          height_m(world.meadow().ground, place_m) + kChestOfHeight * world.walker_traits()[walker].height_m};
}

double yaw_rad(glm::dvec2 forward) {
  return std::atan2(forward.x, forward.y);
}

/// The one present in whose direction the camera looks most.
std::optional<std::size_t> nearest_to_middle(const World& world, const Camera& camera) {
  std::optional<std::size_t> best;
  double most = -2.0;
  for (std::size_t n = 0; n < world.walkers().size(); ++n) {
    if (!world.is_present(n)) continue;
    const glm::dvec3 way_m = chest_m(world, n) - camera.eye_m;
    const double far_m = glm::length(way_m);
    const double cosine = far_m > 0.0 ? glm::dot(way_m, camera.forward()) / far_m : 1.0;
    if (cosine <= most) continue;
    most = cosine;
    best = n;
  }
  return best;
}

}  // namespace

const char* camera_mode_name(CameraMode mode) {
  switch (mode) {
    case CameraMode::kFree:
      return "free";
    case CameraMode::kFollow:
      return "follow";
    case CameraMode::kOrbit:
      break;
  }
  return "orbit";
}

WalkerCamera::WalkerCamera(const Camera& start, const World& world, std::optional<std::size_t> follow)
    : fly_(start, world.meadow().ground), camera_(start) {
  if (!follow || *follow >= world.walkers().size()) return;
  watched_ = follow;
  if (!world.is_present(*follow)) return;
  mode_ = CameraMode::kFollow;
  wanted_distance_m_ = kFirstDistanceM;
  boom_ = {chest_m(world, *follow), yaw_rad(world.walkers()[*follow].forward), kFollowPitchRad,
           kFirstDistanceM};
  look_along_boom(world);
}

void WalkerCamera::resize(glm::ivec2 size_px) {
  camera_.size_px = size_px;
  fly_.resize(size_px);
}

void WalkerCamera::toggle_walking(const HeightField& ground) {
  if (mode_ != CameraMode::kFree) return;
  fly_.toggle_walking(ground);
  camera_ = fly_.camera();
}

void WalkerCamera::watch_next(const World& world) {
  if (!watched_) {
    watched_ = nearest_to_middle(world, camera_);
    return;
  }
  const std::size_t count = world.walkers().size();
  for (std::size_t n = 1; n <= count; ++n) {
    const std::size_t next = (*watched_ + n) % count;
    if (!world.is_present(next)) continue;
    watched_ = next;
    return;
  }
}

void WalkerCamera::change_mode(const World& world) {
  switch (mode_) {
    case CameraMode::kFree:
      if (!watched_) watch_next(world);
      if (watched_) bind(world);
      break;
    case CameraMode::kFollow:
      mode_ = CameraMode::kOrbit;
      break;
    case CameraMode::kOrbit:
      free(world);
      break;
  }
}

// From where the camera is, the boom goes to as far ahead as the walker is.
void WalkerCamera::bind(const World& world) {
  mode_ = CameraMode::kFollow;
  wanted_distance_m_ = kFirstDistanceM;
  const double far_m = glm::distance(chest_m(world, *watched_), camera_.eye_m);
  boom_ = {camera_.eye_m + far_m * camera_.forward(), camera_.yaw_rad, camera_.pitch_rad, far_m};
}

void WalkerCamera::free(const World& world) {
  mode_ = CameraMode::kFree;
  fly_ = FlyCamera(camera_, world.meadow().ground);
}

void WalkerCamera::move(const Steering& steering, double dt_s, const World& world) {
  if (mode_ == CameraMode::kFree) {
    fly_.move(steering, dt_s, world.meadow().ground);
    camera_ = fly_.camera();
    return;
  }
  steer_boom(steering, dt_s);
  approach(dt_s, world);
  look_along_boom(world);
}

void WalkerCamera::steer_boom(const Steering& steering, double dt_s) {
  const double longer = kPerSecond * dt_s * steering.up - kPerNotch * steering.wheel;
  wanted_distance_m_ = std::clamp(wanted_distance_m_ * std::exp(longer), kNearestM, kFarthestM);
  if (mode_ != CameraMode::kOrbit) return;
  boom_.yaw_rad = from_half_turn(boom_.yaw_rad + steering.turn_right_px * kTurnRadPerPx);
  boom_.pitch_rad =
      std::clamp(boom_.pitch_rad + steering.turn_up_px * kTurnRadPerPx, kLowestPitchRad, kHighestPitchRad);
}

void WalkerCamera::approach(double dt_s, const World& world) {
  const auto share = [dt_s](double time_s) { return 1.0 - std::exp(-dt_s / time_s); };
  boom_.distance_m += share(kDistanceTimeS) * (wanted_distance_m_ - boom_.distance_m);
  // Who has gone is looked after.
  if (!world.is_present(*watched_)) return;
  boom_.target_m += share(kTargetTimeS) * (chest_m(world, *watched_) - boom_.target_m);
  if (mode_ != CameraMode::kFollow) return;
  const double behind_rad = from_half_turn(yaw_rad(world.walkers()[*watched_].forward) - boom_.yaw_rad);
  boom_.yaw_rad = from_half_turn(boom_.yaw_rad + share(kHeadingTimeS) * behind_rad);
  boom_.pitch_rad += share(kHeadingTimeS) * (kFollowPitchRad - boom_.pitch_rad);
}

void WalkerCamera::look_along_boom(const World& world) {
  camera_.yaw_rad = boom_.yaw_rad;
  camera_.pitch_rad = boom_.pitch_rad;
  camera_.eye_m = boom_.target_m - boom_.distance_m * camera_.forward();
  const double lowest_m = height_m(world.meadow().ground, glm::dvec2(camera_.eye_m)) + kLowestEyeM;
  if (camera_.eye_m.z >= lowest_m) return;
  camera_.eye_m.z = lowest_m;
  const glm::dvec3 way_m = boom_.target_m - camera_.eye_m;
  camera_.pitch_rad = std::atan2(way_m.z, glm::length(glm::dvec2(way_m)));
}

}  // namespace prairie
