#include "app/viewer/play.h"

#include <algorithm>
#include <chrono>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "animation/heading.h"
#include "app/scenes/world_time.h"
#include "world/motion.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr double kGustBehindM = 20.0;
constexpr double kTornadoAheadM = 15.0;
constexpr double kTornadoTravelMPerS = 1.0;
constexpr double kStoneAheadM = 4.0;
constexpr double kCartAheadM = 4.0;
constexpr double kFarthestM = 1e6;  // beyond it nothing moves

/// From east, counter-clockwise.
double heading_rad(const Camera& camera) {
  return glm::radians(90.0) - camera.yaw_rad;
}

glm::dvec2 within_reach(glm::dvec2 place_m) {
  return glm::clamp(place_m, glm::dvec2(-kFarthestM), glm::dvec2(kFarthestM));
}

glm::dvec2 ahead_m(const Camera& camera, double way_m) {
  return within_reach(glm::dvec2(camera.eye_m) + way_m * direction_of(heading_rad(camera)));
}

DrivenMover mover_of(const RollingStone& stone, const HeightField& ground) {
  const MoverPlace place = place_of(stone, ground);
  return {MoverKind::kStone, stone.radius_m, place, place, stone.rolled_m};
}

DrivenMover mover_of(const DrivenCart& cart, const HeightField& ground) {
  const MoverPlace place = place_of(cart, ground);
  return {MoverKind::kCart, cart.half_width_m, place, place, cart.rolled_m};
}

}  // namespace

Play::Play(World& world, bool paused)
    : world_(world), clock_(paused), wind_(wind_controls_of(world.scene(), world.motion().wind())) {
  world_.driven().clear();
  world_.motion().wake(true);
}

void Play::look(const Camera& camera) {
  world_.motion().watch(within_reach(watched_place_m(camera, world_.meadow().ground)));
}

void Play::advance(double passed_s, const CartControls& controls, const Camera& camera) {
  look(camera);
  const EvenSteps steps = clock_.take(passed_s);
  if (steps.count == 0) return;
  const auto start = std::chrono::steady_clock::now();
  for (int n = 0; n < steps.count; ++n) {
    move_driven(controls, steps.dt_s);
    world_.step(steps.dt_s);
  }
  steps_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void Play::move_driven(const CartControls& controls, double dt_s) {
  const HeightField& ground = world_.meadow().ground;
  if (stone_) stone_ = rolled_on(*stone_, dt_s);
  if (cart_) cart_ = driven_on(*cart_, controls, dt_s, ground);
  for (DrivenMover& driven : world_.driven()) {
    const bool is_stone = driven.kind == MoverKind::kStone;
    driven.place = is_stone ? place_of(*stone_, ground) : place_of(*cart_, ground);
    driven.rolled_m = is_stone ? stone_->rolled_m : cart_->rolled_m;
  }
}

void Play::set_wind(const WindControls& wind) {
  if (wind == wind_) return;
  wind_ = wind;
  blow(wind_, world_);
}

void Play::send_gust(const Camera& camera) {
  Gust gust;
  gust.origin_m = ahead_m(camera, -kGustBehindM);
  gust.heading_rad = heading_rad(camera);
  gust.start_s = world_.time_s();
  world_.motion().spawn(gust);
}

void Play::send_tornado(const Camera& camera) {
  Tornado tornado;
  tornado.origin_m = ahead_m(camera, kTornadoAheadM);
  tornado.heading_rad = heading_rad(camera);
  tornado.travel_m_per_s = kTornadoTravelMPerS;
  tornado.start_s = world_.time_s();
  world_.motion().spawn(tornado);
}

// There is one thing of each kind at most.
void Play::put_down(DrivenMover mover) {
  std::erase_if(world_.driven(), [&](const DrivenMover& old) { return old.kind == mover.kind; });
  world_.driven().push_back(mover);
}

void Play::roll_stone(const Camera& camera) {
  stone_.emplace();
  stone_->start_m = ahead_m(camera, kStoneAheadM);
  stone_->heading_rad = heading_rad(camera);
  put_down(mover_of(*stone_, world_.meadow().ground));
}

void Play::take_cart(const Camera& camera) {
  cart_.emplace();
  cart_->position_m = ahead_m(camera, kCartAheadM);
  cart_->heading_rad = heading_rad(camera);
  put_down(mover_of(*cart_, world_.meadow().ground));
}

void Play::leave_cart() {
  std::erase_if(world_.driven(), [](const DrivenMover& old) { return old.kind == MoverKind::kCart; });
  cart_.reset();
}

}  // namespace prairie
