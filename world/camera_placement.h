// A first camera for a scene that nobody has looked at yet: a standing person's eyes on planted, measured
// ground, turned to where the meadow goes on longest.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "generator/meadow.h"
#include "world/scene/scene.h"

namespace prairie {

inline constexpr double kEyeHeightM = 1.7;

/// Whether something grows at the position and its ground is measured.
bool is_planted(const Meadow& meadow, glm::dvec2 position_m);

/// Camera `name` at eye height on planted ground, as near to the middle of the scene as it has a long view
/// over planted ground from there; where nothing grows, in the middle, looking north.
CameraSpec placed_camera_spec(const Meadow& meadow, const std::string& name);

/// Pitch, degrees, of a look from eye height to the ground `distance_m` ahead.
double pitch_to_ground_deg(const Meadow& meadow, glm::dvec2 position_m, double yaw_deg, double eye_height_m,
                           double distance_m);

}  // namespace prairie
