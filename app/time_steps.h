// Through a world's time in even steps that end when they should.
#pragma once

#include "world/world.h"

namespace prairie {

/// The longest step that commands take by themselves.
inline constexpr double kLongestStepS = 1.0 / 60.0;

/// How many even steps of at most kLongestStepS an interval takes.
int steps_in(double interval_s);

/// Steps the world to this time; not at all where that has passed.
void step_to(World& world, double time_s);

}  // namespace prairie
