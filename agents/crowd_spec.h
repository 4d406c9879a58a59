// Who walks in a meadow: groups of walkers, as a scene describes them.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "agents/behaviour.h"

namespace prairie {

struct WalkerGroup {
  std::string name;
  std::uint32_t count = 1;           // 0…kMostWalkers in all
  std::string behaviour = "wander";  // of behaviours()
  std::vector<Goal> goals;
  glm::dvec2 centre_m{0.0};          // they start strewn over a disc,
  double radius_m = 5.0;             // 0…1e4
  std::vector<glm::dvec2> starts_m;  // or here, one place for each
  double speed_m_per_s = 1.3;        // on level, bare ground; 0.1…3
  double speed_spread = 0.12;        // share by which walkers differ, at most; 0…0.5
  double height_m = 1.75;            // 0.6…2.5
  double height_spread = 0.06;       // share; 0…0.3
  double body_radius_m = 0.25;       // seen from above, of a walker of 1.75 m; 0.1…0.6
  double sensor_m = 4.0;             // how far it sees; 0.5…10
  double noise = 0.12;               // σ₀ of speed (share) and heading (rad); 0…0.6
};

inline constexpr std::uint32_t kMostWalkers = 100'000;
inline constexpr std::uint32_t kMostGoals = 1000;
inline constexpr double kMostSensorM = 10.0;

/// Throws BadInput, the field in it.
void check(const WalkerGroup& group);

}  // namespace prairie
