#include "agents/behaviour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "agents/plane_vectors.h"

namespace prairie {
namespace {

constexpr double kForgetsTurnS = 1.5;     // after it has been free for so long
constexpr double kWanderTurnRad = 0.5;    // deviation of where a wanderer turns to
constexpr double kStrollM = 12.0;         // a stroller turns back beyond
constexpr double kNearerM = 0.3;          // a detour is over when the goal is so much nearer than before it
constexpr double kGivesUpDetourS = 60.0;  // and goes round the other way
constexpr double kFollowM = 0.8;          // distance at which it goes along what it goes round
constexpr double kHeldUpS = 1.5;          // after which it backs off
constexpr double kBacksOffS = 1.6;
constexpr double kMoves = 0.12;       // share of the canonical speed
constexpr double kLeastSpeed = 0.25;  // share of the canonical one, before an obstacle

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

double smooth(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

/// Turned by a small angle, rad, to the left.
glm::dvec2 turned(glm::dvec2 forward, double angle_rad) {
  return turned_by_half_tangent(forward, 0.5 * angle_rad);
}

MotorCommand wander(const Sight& sight, Memory& memory) {
  const double closeness = noise_deviation(kWanderTurnRad, sight.nearest.distance_m, sight.sensor_m);
  return avoiding(sight, turned(sight.forward, closeness * sight.turn_noise), memory);
}

MotorCommand stroll(const Sight& sight, Memory& memory) {
  const glm::dvec2 to_home = sight.home_m - sight.position_m;
  const double away_m = glm::length(to_home);
  if (away_m <= kStrollM) return wander(sight, memory);
  const double pull = std::min((away_m - kStrollM) / kStrollM, 1.0);
  return avoiding(sight, unit(sight.forward + 2.0 * pull * (to_home / away_m), to_home / away_m), memory);
}

/// Straight to a place, or along what is in the way until the place is nearer than where that was met.
MotorCommand head_for(const Sight& sight, glm::dvec2 place_m, Memory& memory) {
  const glm::dvec2 way = place_m - sight.position_m;
  const double away_m = glm::length(way);
  const glm::dvec2 wanted = unit(way, sight.forward);
  const Percept& nearest = sight.nearest;
  const bool is_solid = nearest.kind == Percept::Kind::kObstacle;
  if (memory.met_m < 0.0) {
    // What lies beyond the goal is not in the way.
    const bool is_in_way = is_solid && nearest.distance_m < kFollowM &&
                           glm::dot(wanted, nearest.toward) > 0.5 && away_m > nearest.distance_m;
    if (!is_in_way) return avoiding(sight, wanted, memory);
    memory.met_m = away_m;
    memory.met_s = sight.time_s;
    memory.turn = cross(nearest.toward, wanted) >= 0.0 ? 1 : -1;
  }
  const bool is_past = away_m < memory.met_m - kNearerM && glm::dot(wanted, nearest.toward) < 0.2;
  if (is_past || nearest.kind == Percept::Kind::kNothing) {
    memory.met_m = -1.0;
    return avoiding(sight, wanted, memory);
  }
  if (sight.time_s - memory.met_s > kGivesUpDetourS) {
    memory.met_s = sight.time_s;
    memory.turn = -memory.turn;
  }
  const bool is_held_up = sight.time_s - memory.moved_s > kHeldUpS || sight.time_s < memory.backs_off_until_s;
  if (!is_solid || is_held_up) return avoiding(sight, sight.forward, memory);
  if (sight.moving_m_per_s > kMoves * sight.speed_m_per_s) memory.moved_s = sight.time_s;
  // Along it, on the side to which it turned, at a distance.
  const glm::dvec2 along = static_cast<double>(memory.turn) * left_of(nearest.toward);
  const double pull = std::clamp((nearest.distance_m - kFollowM) / kFollowM, -1.0, 1.0);
  memory.turned_s = sight.time_s;
  const double ahead = std::max(glm::dot(sight.forward, nearest.toward), 0.0);
  const double room = std::clamp(nearest.distance_m / kFollowM, 0.0, 1.0);
  return {sight.speed_m_per_s * std::max(kLeastSpeed, 1.0 - ahead * (1.0 - 0.5 * room)),
          unit(along + 0.8 * pull * nearest.toward, along)};
}

MotorCommand to_goals(const Sight& sight, Memory& memory, bool again) {
  if (sight.goals.empty()) return wander(sight, memory);
  const auto count = static_cast<std::int32_t>(sight.goals.size());
  const auto goal_of = [&](std::int32_t n) {
    return sight.goals[static_cast<std::size_t>(std::clamp(n, 0, count - 1))];
  };
  const Goal goal = goal_of(memory.goal);
  if (glm::length(goal.position_m - sight.position_m) > goal.radius_m) {
    memory.goal_since_s = -1.0;  // pushed aside while it stayed, it goes back
    return head_for(sight, goal.position_m, memory);
  }
  if (memory.goal_since_s < 0.0) memory.goal_since_s = sight.time_s;
  memory.met_m = -1.0;
  const bool is_last = memory.goal == count - 1;
  const bool stays = sight.time_s - memory.goal_since_s < goal.stay_s || (is_last && !again) || count == 1;
  if (stays) {
    memory.moved_s = sight.time_s;
    return {0.0, sight.forward};
  }
  memory.goal = (memory.goal + 1) % count;
  memory.goal_since_s = -1.0;
  return head_for(sight, goal_of(memory.goal).position_m, memory);
}

MotorCommand visit(const Sight& sight, Memory& memory) {
  return to_goals(sight, memory, true);
}

MotorCommand go(const Sight& sight, Memory& memory) {
  return to_goals(sight, memory, false);
}

constexpr std::array<Behaviour, 4> kBehaviours{{
    {"wander", "goes where it likes", false, wander},
    {"visit", "goes from goal to goal, for ever", true, visit},
    {"go", "goes from goal to goal and stays at the last", true, go},
    {"stroll", "wanders about where it started", false, stroll},
}};

}  // namespace

std::span<const Behaviour> behaviours() {
  return kBehaviours;
}

const Behaviour* find_behaviour(std::string_view name) {
  const auto found = std::find_if(kBehaviours.begin(), kBehaviours.end(),
                                  [&](const Behaviour& b) { return b.name == name; });
  return found == kBehaviours.end() ? nullptr : &*found;
}

double noise_deviation(double deviation, double distance_m, double sensor_m) {
  return deviation * std::clamp(distance_m / sensor_m, 0.0, 1.0);
}

MotorCommand avoiding(const Sight& sight, glm::dvec2 wanted, Memory& memory) {
  const Percept& nearest = sight.nearest;
  if (nearest.kind == Percept::Kind::kNothing || sight.moving_m_per_s > kMoves * sight.speed_m_per_s)
    memory.moved_s = sight.time_s;
  if (sight.time_s - memory.moved_s > kHeldUpS && sight.time_s > memory.backs_off_until_s) {
    memory.backs_off_until_s = sight.time_s + kBacksOffS;
    memory.turn = -memory.turn;
  }
  if (sight.time_s < memory.backs_off_until_s) {
    memory.moved_s = memory.turned_s = sight.time_s;
    return {0.6 * sight.speed_m_per_s, -nearest.toward};
  }
  const double share = std::clamp(nearest.distance_m / sight.sensor_m, 0.0, 1.0);
  const double facing = glm::dot(wanted, nearest.toward);
  if (nearest.kind == Percept::Kind::kNothing || facing <= 0.0) {
    if (sight.time_s - memory.turned_s > kForgetsTurnS) memory.turn = 0;
    return {sight.speed_m_per_s, wanted};
  }
  if (memory.turn == 0) memory.turn = cross(nearest.toward, wanted) >= 0.0 ? 1 : -1;
  memory.turned_s = sight.time_s;
  // Far away the wish holds; near it the way leads along the obstacle and a little away from it.
  const double closeness = smooth(1.0 - share);
  const glm::dvec2 along = static_cast<double>(memory.turn) * left_of(nearest.toward);
  const glm::dvec2 away = unit(along - 0.35 * nearest.toward, along);
  const glm::dvec2 heading = unit((1.0 - closeness) * wanted + 1.6 * closeness * away, away);
  const double ahead = std::max(glm::dot(sight.forward, nearest.toward), 0.0);
  const double slowed = 1.0 - ahead * (1.0 - smooth(1.6 * share));
  return {sight.speed_m_per_s * std::max(kLeastSpeed, slowed), heading};
}

}  // namespace prairie
