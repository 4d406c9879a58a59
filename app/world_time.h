// Bringing a world to the time of a picture.
#pragma once

#include "lod/camera.h"
#include "world/world.h"

namespace prairie {

inline constexpr double kStepsPerS = 60.0;
inline constexpr double kMaxTimeS = 86'400.0;

/// Steps the world to that time, not before its own, in steps of at most 1/kStepsPerS.
void advance_to(World& world, double to_s);

/// The place on the ground around which a camera sees moving grass: below its eye, or for one that looks down from afar in
/// parallel projection, the middle of what it sees.
glm::dvec2 watched_place_m(const Camera& camera, const HeightField& ground);

}  // namespace prairie
