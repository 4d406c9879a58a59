// The wind that a moving camera makes (RG, "Wind Simulation"): velocities on a square of nodes around it,
// which move along with it node by node, so that what was stirred up stays where it is.
//
//   v' = damping · v + a        a points away from the camera, less with distance, and counts only along its
//   motion
//
// Deviations: damping is per second, dv/dt = −λ v + a, integrated exactly over a step; a grows with the
// camera's speed, so that a slow camera stirs little and the frame rate does not matter; nodes lie at places
// of the world, not of tiles.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "animation/node_field.h"

namespace prairie {

struct CameraWakeSettings {
  int nodes = 33;               // along a side; odd, 3…257
  double spacing_m = 1.0;       // 0.1…10
  double damping_per_s = 1.2;   // λ: rate at which velocities die down, 0.01…100
  double stirring_per_s = 2.0;  // acceleration next to the camera by its speed, 0…100
  double spread_m = 6.0;        // distance from which nothing is stirred, 0.1…1000
  double most_m_per_s = 12.0;   // of what it stirs up, 0…100
};

/// All that changes; plain data.
struct CameraWakeState {
  double time_s = 0.0;
  bool placed = false;  // whether the camera has been anywhere yet
  glm::dvec2 camera_m{0.0};
  NodeIndex south_west;
  std::vector<glm::vec2> velocities_m_per_s;  // row by row from south-west

  bool operator==(const CameraWakeState&) const = default;
};

class CameraWake {
 public:
  /// Throws BadInput on settings out of range.
  explicit CameraWake(const CameraWakeSettings& settings);

  const CameraWakeSettings& settings() const { return settings_; }
  const CameraWakeState& state() const { return state_; }
  /// Throws BadInput, and changes nothing, if the state is not one of these settings.
  void restore(CameraWakeState state);

  /// The camera has moved to a place. One that jumps farther than the square stirs nothing and leaves its
  /// wake behind. Throws BadInput, and changes nothing, if time goes backwards or a number is not finite.
  void step(glm::dvec2 camera_m, double to_s);

  /// Bilinear between nodes, 0 from the outermost nodes' neighbours on.
  glm::vec2 velocity_m_per_s(glm::dvec2 position_m) const;

 private:
  glm::vec2 at(NodeIndex node) const;

  CameraWakeSettings settings_;
  CameraWakeState state_;
};

}  // namespace prairie
