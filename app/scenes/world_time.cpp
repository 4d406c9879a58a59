#include "app/scenes/world_time.h"

#include <cmath>

#include "world/motion.h"
#include "world/world.h"

namespace prairie {

int steps_in(double interval_s) {
  constexpr double kRounding = 1e-6;  // a sixtieth of a second plus a rounding error is one step
  return interval_s > 0.0 ? static_cast<int>(std::ceil(interval_s / kLongestStepS - kRounding)) : 0;
}

void advance_to(World& world, double time_s) {
  // The world rounds its steps, so that each is a share of what is left.
  for (int left = steps_in(time_s - world.time_s()); left > 0; --left)
    world.step((time_s - world.time_s()) / left);
}

glm::dvec2 watched_place_m(const Camera& camera, const HeightField& ground) {
  const glm::dvec2 below_m(camera.eye_m);
  const glm::dvec3 forward = camera.forward();
  if (!camera.is_orthographic() || forward.z > -1e-3) return below_m;
  const double ground_m = static_cast<double>(ground.height_m(below_m));
  return below_m + glm::dvec2(forward) * ((ground_m - camera.eye_m.z) / forward.z);
}

void look_through(const Camera& camera, World& world) {
  const glm::dvec2 place_m = watched_place_m(camera, world.meadow().ground);
  if (world.motion().eye_m()) {
    world.motion().watch(place_m);
  } else {
    world.watch_anew(place_m);
  }
}

}  // namespace prairie
