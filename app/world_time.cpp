#include "app/world_time.h"

#include <cmath>

namespace prairie {

void advance_to(World& world, double to_s) {
  constexpr std::int64_t kStep = kTicksPerS / static_cast<std::int64_t>(kStepsPerS);
  const std::int64_t to = std::llround(to_s * static_cast<double>(kTicksPerS));
  while (world.motion().ticks() < to) {
    const std::int64_t ticks = std::min(kStep, to - world.motion().ticks());
    world.step(static_cast<double>(ticks) / static_cast<double>(kTicksPerS));
  }
}

glm::dvec2 watched_place_m(const Camera& camera, const HeightField& ground) {
  const glm::dvec2 below_m(camera.eye_m);
  const glm::dvec3 forward = camera.forward();
  if (!camera.is_orthographic() || forward.z > -1e-3) return below_m;
  const double ground_m = static_cast<double>(ground.height_m(below_m));
  return below_m + glm::dvec2(forward) * ((ground_m - camera.eye_m.z) / forward.z);
}

}  // namespace prairie
