// Fields made visible over the picture: the wind as arrows, treads as heat on the ground. What is drawn, as
// plain data.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "shaders/shared/layouts.h"

namespace prairie {

class World;

enum class FieldOverlay {
  kNone,
  kWind,     // arrows on a lattice of 2 m, as long and as warm as the wind is fast
  kTilt,     // how far trodden grass lies down
  kRecovery  // how far it is from having risen again, and how worn the ground is
};

/// Around the eye, 0.3 m above the ground.
std::vector<WindArrow> wind_arrows(const World& world, glm::dvec3 eye_m);

/// Around the eye, just above the ground; nothing where no grass was trodden. `heat`: of kTilt, tilt by the
/// most there can be; of kRecovery, the share of the way to rest that is left.
std::vector<HeatSquare> heat_squares(const World& world, glm::dvec3 eye_m, FieldOverlay overlay);

inline constexpr double kWindArrowsReachM = 24.0;
inline constexpr double kHeatReachM = 30.0;

}  // namespace prairie
