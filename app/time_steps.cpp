#include "app/time_steps.h"

#include <cmath>

namespace prairie {

int steps_in(double interval_s) {
  constexpr double kRounding = 1e-6;  // a sixtieth of a second plus a rounding error is one step
  return interval_s > 0.0 ? static_cast<int>(std::ceil(interval_s / kLongestStepS - kRounding)) : 0;
}

void step_to(World& world, double time_s) {
  // The world rounds its steps, so that each is a share of what is left.
  for (int left = steps_in(time_s - world.time_s()); left > 0; --left)
    world.step((time_s - world.time_s()) / left);
}

}  // namespace prairie
