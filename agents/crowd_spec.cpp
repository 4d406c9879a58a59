#include "agents/crowd_spec.h"

#include <fmt/format.h>

#include "animation/range_check.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kFarthestM = 1e6;

void check_place(const std::string& field, glm::dvec2 place_m) {
  check_range(field, place_m.x, -kFarthestM, kFarthestM);
  check_range(field, place_m.y, -kFarthestM, kFarthestM);
}

void check_count(const std::string& field, std::size_t count, std::size_t most) {
  if (count > most) throw BadInput("", field, fmt::format("{}", count), fmt::format("at most {}", most));
}

}  // namespace

void check(const WalkerGroup& group) {
  check_count("count", group.count, kMostWalkers);
  const Behaviour* behaviour = find_behaviour(group.behaviour);
  if (behaviour == nullptr) {
    std::string known;
    for (const Behaviour& one : behaviours())
      known += fmt::format("{}{}", known.empty() ? "" : ", ", one.name);
    throw BadInput("", "behaviour", group.behaviour, "one of " + known);
  }
  if (behaviour->needs_goals && group.goals.empty())
    throw BadInput("", "goals", "none",
                   fmt::format("at least one, for the behaviour \"{}\"", group.behaviour));
  check_count("goals", group.goals.size(), kMostGoals);
  for (const Goal& goal : group.goals) {
    check_place("goals.position_m", goal.position_m);
    check_range("goals.radius_m", goal.radius_m, 0.2, 1e4);
    check_range("goals.stay_s", goal.stay_s, 0.0, 1e9);
  }
  check_place("centre_m", group.centre_m);
  check_range("radius_m", group.radius_m, 0.0, 1e4);
  if (!group.starts_m.empty() && group.starts_m.size() != group.count)
    throw BadInput("", "starts_m", fmt::format("{} places", group.starts_m.size()),
                   fmt::format("one for each of the {} walkers", group.count));
  for (const glm::dvec2 start_m : group.starts_m) check_place("starts_m", start_m);
  check_range("speed_m_per_s", group.speed_m_per_s, 0.1, 3.0);
  check_range("speed_spread", group.speed_spread, 0.0, 0.5);
  check_range("height_m", group.height_m, 0.6, 2.5);
  check_range("height_spread", group.height_spread, 0.0, 0.3);
  check_range("body_radius_m", group.body_radius_m, 0.1, 0.6);
  check_range("sensor_m", group.sensor_m, 0.5, kMostSensorM);
  check_range("noise", group.noise, 0.0, 0.6);
}

}  // namespace prairie
