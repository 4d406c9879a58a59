// A walker: what stays the same of it and what changes.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "agents/behaviour.h"
#include "agents/footing.h"

namespace prairie {

/// What does not change of a walker.
struct WalkerTraits {
  std::uint32_t group = 0;
  std::uint32_t id = 0;  // counted through all groups
  double height_m = 1.75;
  double radius_m = 0.25;      // of its body's disc
  double speed_m_per_s = 1.3;  // canonical
  double sensor_m = 4.0;
  double noise = 0.12;
  glm::dvec2 home_m{0.0};  // where it started
  const Behaviour* behaviour = nullptr;
};

/// All that changes of a walker; plain data.
struct Walker {
  glm::dvec2 position_m{0.0};
  glm::dvec2 forward{1.0, 0.0};  // unit
  double speed_m_per_s = 0.0;
  Footing footing;
  Memory memory;

  bool operator==(const Walker&) const = default;
};

}  // namespace prairie
