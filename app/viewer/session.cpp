#include "app/viewer/session.h"

#include <algorithm>

#include "world/world.h"

namespace prairie {
namespace {

constexpr double kLongestStepS = 0.25;  // a slow frame must not throw the camera across the meadow

}  // namespace

Session::Session(World& shown, const Camera& start, const ViewerOptions& options)
    : world(shown), camera(start, shown, options.follow), steering(shown), play(shown, options.paused) {
  play.look(camera.camera());
  if (options.walker_overlay) walker_overlay = WalkerOverlay::kBoth;
  frame_options.tier = options.tier;
  frame_options.msaa = options.msaa;
  frame_options.quality = world.scene().lod.quality;
  frame_options.memory_budget_bytes = options.memory_budget_bytes;
}

void Session::move_camera(const Steering& asked, double passed_s, glm::ivec2 size_px) {
  camera.resize(size_px);
  camera.move(asked, std::min(passed_s, kLongestStepS), world);
}

void Session::advance(double passed_s, const CartControls& arrows, bool fast) {
  steering.steer({arrows.drive, arrows.steer, fast});
  play.advance(passed_s, steering.steered() ? CartControls{} : arrows, camera.camera());
  trails.follow(world, camera.camera().eye_m);
}

ShownWalkers Session::shown_walkers() const {
  const glm::dvec3 eye_m = camera.camera().eye_m;
  const bool told = panels_shown && camera.watched();
  ShownWalkers shown;
  if (told || shows_sensors(walker_overlay)) shown.percepts = world.percepts();
  if (shows_paths(walker_overlay)) shown.lines = path_lines(world, trails, eye_m);
  if (shows_sensors(walker_overlay)) {
    const std::vector<LineSegment> sensors = sensor_lines(world, shown.percepts, eye_m);
    shown.lines.insert(shown.lines.end(), sensors.begin(), sensors.end());
  }
  return shown;
}

bool Session::has_walkers() const {
  return !world.walkers().empty();
}

void Session::watch_next_walker() {
  camera.watch_next(world);
  steering.keep_only(camera.watched());
}

}  // namespace prairie
