// Bringing a world to the time of a picture, and to where it is seen from.
#pragma once

#include <glm/vec2.hpp>

#include "lod/camera.h"

namespace prairie {

class HeightField;
class World;

/// The longest step that commands take by themselves.
inline constexpr double kLongestStepS = 1.0 / 60.0;
inline constexpr double kMaxTimeS = 86'400.0;

/// How many even steps of at most kLongestStepS an interval takes.
int steps_in(double interval_s);

/// Steps the world to this time in even steps that end there; not at all where that has passed.
void advance_to(World& world, double time_s);

/// The place on the ground around which a camera sees moving grass: below its eye, or for one that looks down
/// from afar in parallel projection, the middle of what it sees.
glm::dvec2 watched_place_m(const Camera& camera, const HeightField& ground);

/// The world is seen through this camera from now on.
void look_through(const Camera& camera, World& world);

}  // namespace prairie
