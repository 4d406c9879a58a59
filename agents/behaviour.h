// How walkers decide (G03 §5.2): from what a walker perceives of the nearest obstacle, (d, θ), to a motor
// command, (v, φ). A behaviour is a value; a scene chooses it by name. Another one is a function more in the
// table of behaviours(), and nothing else changes.
//
// G03: v falls as an obstacle comes near; φ turns away from θ; Gaussian noise is added, less of it the nearer
// the obstacle. The paper's σ ∝ 1/d would do the opposite of what it is for; here σ = σ₀ min(1, d/d_sensor).
// Beyond the paper, walkers remember to which side they turn until they are free, so that corners do not turn
// them to and fro; who is held up between several things, of which it sees the nearest alone, backs off; and
// a walker with a goal goes round what it met until it is nearer to the goal than where it met it (after the
// "bug" algorithms of Lumelsky and Stepanov 1987), so that dead ends are left again.
//
// All by +, −, ×, ÷ and √.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace prairie {

/// The nearest thing inside the sensor range.
struct Percept {
  enum class Kind : std::uint32_t { kNothing, kObstacle, kWalker, kMover };

  Kind kind = Kind::kNothing;
  double distance_m = 0.0;      // d, between the edges in the plan; the sensor range where there is nothing
  glm::dvec2 toward{1.0, 0.0};  // unit: the heading plus θ

  bool operator==(const Percept&) const = default;
};

/// Where a walker wants to be.
struct Goal {
  glm::dvec2 position_m{0.0};
  double radius_m = 1.0;  // it is reached from here on
  double stay_s = 0.0;    // before the next one

  bool operator==(const Goal&) const = default;
};

/// What a walker keeps in mind; plain data, part of a saved state.
struct Memory {
  std::int32_t turn = 0;       // the side to which it turns away: 1 left, −1 right, 0 none
  double turned_s = -1e9;      // when it last had to
  std::int32_t goal = 0;       // towards which it is on its way
  double goal_since_s = -1.0;  // since when it stays there; before, negative
  double met_m = -1.0;         // how far from the goal it met what it goes round; negative: nothing
  double met_s = 0.0;          // when

  double moved_s = 0.0;  // when it last came along
  double backs_off_until_s = -1e9;

  bool operator==(const Memory&) const = default;
};

/// What a decision is made from.
struct Sight {
  double time_s = 0.0;
  glm::dvec2 position_m{0.0};
  glm::dvec2 forward{1.0, 0.0};  // unit
  double moving_m_per_s = 0.0;   // how fast it is now
  Percept nearest;
  double sensor_m = 4.0;
  double speed_m_per_s = 1.3;  // canonical: of this walker when nothing is in its way
  glm::dvec2 home_m{0.0};      // where it started
  double turn_noise = 0.0;     // slow noise of mean 0 and deviation 1
  std::span<const Goal> goals;
};

struct MotorCommand {
  double speed_m_per_s = 0.0;    // v
  glm::dvec2 heading{1.0, 0.0};  // φ, as a unit vector
};

struct Behaviour {
  std::string_view name;
  std::string_view what;  // in a line
  bool needs_goals;
  MotorCommand (*decide)(const Sight& sight, Memory& memory);
};

/// wander, visit, go, stroll.
std::span<const Behaviour> behaviours();
/// Null where there is none of that name.
const Behaviour* find_behaviour(std::string_view name);

/// The command that leads where `wanted` points as far as obstacles let it. `wanted`: a unit vector.
MotorCommand avoiding(const Sight& sight, glm::dvec2 wanted, Memory& memory);

/// σ for an obstacle at d (facts: the paper's intent, not its formula); `deviation`: σ₀.
double noise_deviation(double deviation, double distance_m, double sensor_m);

}  // namespace prairie
