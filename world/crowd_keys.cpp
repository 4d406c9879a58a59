#include "world/crowd_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "world/bearing.h"
#include "world/foreign_check.h"
#include "world/point_list.h"
#include "world/scene_names.h"

namespace prairie {
namespace {

constexpr Bounds kBearingDeg{-360.0, 360.0};

void check_count(const TableReader& root, std::string_view key, std::size_t count, std::size_t most) {
  if (count > most) root.refuse(key, fmt::format("{} of them", count), fmt::format("at most {}", most));
}

double read_heading(TableReader& table) {
  return heading_rad_of(table.number("heading_deg", kBearingDeg).value_or(90.0));
}

glm::dvec3 read_size(TableReader& table, glm::dvec3 fallback) {
  const toml::node* value = table.node("size_m");
  if (value == nullptr) return fallback;
  const auto* list = value->as_array();
  if (list == nullptr || list->size() != 3) table.refuse("size_m", "[ahead, across, up] in metres");
  glm::dvec3 size_m{};
  for (glm::length_t n = 0; n < 3; ++n)
    size_m[n] = table.checked_number("size_m", (*list)[static_cast<std::size_t>(n)], {0.0, 1e6});
  return size_m;
}

Obstacle read_obstacle(TableReader& table) {
  const auto kind = table.choice("kind", {"trunk", "box", "rock"});
  if (!kind) table.refuse_missing("kind", "\"trunk\", \"box\" or \"rock\"");
  const glm::dvec2 position_m = need_place(table, "position_m");
  if (*kind == 0) {
    Trunk trunk;
    trunk.position_m = position_m;
    trunk.radius_m = table.any_number("radius_m").value_or(trunk.radius_m);
    trunk.height_m = table.any_number("height_m").value_or(trunk.height_m);
    return trunk;
  }
  if (*kind == 1) {
    Block block;
    block.position_m = position_m;
    block.size_m = read_size(table, block.size_m);
    block.heading_rad = read_heading(table);
    return block;
  }
  Rock rock;
  rock.position_m = position_m;
  rock.size_m = read_size(table, rock.size_m);
  rock.heading_rad = read_heading(table);
  if (const auto seed = table.integer("seed", 0, std::numeric_limits<std::uint32_t>::max()))
    rock.seed = static_cast<std::uint32_t>(*seed);
  return rock;
}

Wall read_wall(TableReader& table) {
  Wall wall;
  wall.outline.outer_m = read_points(table, "outline_m", {3, kMaxPathPoints});
  wall.outline.holes_m = read_point_lists(table, "holes_m", {3, kMaxPathPoints});
  if (const auto side = table.choice("walkers", {"inside", "outside"}))
    wall.walkers = static_cast<WallSide>(*side);
  wall.height_m = table.any_number("height_m").value_or(wall.height_m);
  return wall;
}

GoalSpec read_goal(TableReader& table, const std::vector<std::string>& taken) {
  GoalSpec spec;
  spec.name = read_name(table, taken);
  spec.goal.position_m = need_place(table, "position_m");
  spec.goal.radius_m = table.number("radius_m", {0.2, 1e4}).value_or(spec.goal.radius_m);
  spec.goal.stay_s = table.number("stay_s", {0.0, 1e9}).value_or(spec.goal.stay_s);
  return spec;
}

/// The goals of those names, in their order.
std::vector<Goal> read_goal_names(TableReader& table, const std::vector<GoalSpec>& known) {
  std::vector<Goal> goals;
  const toml::node* value = table.node("goals");
  if (value == nullptr) return goals;
  const std::string expected = "names of [[goal]]s";
  const auto* list = value->as_array();
  if (list == nullptr || list->size() > kMostGoals) table.refuse("goals", expected);
  for (const toml::node& element : *list) {
    const auto name = element.value<std::string>();
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const GoalSpec& one) { return name && one.name == *name; });
    if (found == known.end()) table.refuse("goals", name ? printable(*name) : "no text", expected);
    goals.push_back(found->goal);
  }
  return goals;
}

struct NumberKey {
  const char* key;  // as the member
  double WalkerGroup::*member;
};

// Their ranges are those of agents/crowd_spec.h.
constexpr NumberKey kGroupKeys[] = {
    {"radius_m", &WalkerGroup::radius_m},           {"speed_m_per_s", &WalkerGroup::speed_m_per_s},
    {"speed_spread", &WalkerGroup::speed_spread},   {"height_m", &WalkerGroup::height_m},
    {"height_spread", &WalkerGroup::height_spread}, {"body_radius_m", &WalkerGroup::body_radius_m},
    {"sensor_m", &WalkerGroup::sensor_m},           {"noise", &WalkerGroup::noise},
};

WalkerGroup read_group(TableReader& table, const std::vector<GoalSpec>& goals,
                       const std::vector<std::string>& taken) {
  WalkerGroup group;
  group.name = read_name(table, taken);
  if (const auto count = table.integer("count", 0, std::numeric_limits<std::uint32_t>::max()))
    group.count = static_cast<std::uint32_t>(*count);
  group.behaviour = table.text("behaviour").value_or(group.behaviour);
  group.goals = read_goal_names(table, goals);
  if (table.node("starts_m") != nullptr) {
    group.starts_m = read_points(table, "starts_m", {1, kMostWalkers});
    group.count = static_cast<std::uint32_t>(group.starts_m.size());
  } else {
    group.centre_m = need_place(table, "position_m");
  }
  for (const auto& [key, member] : kGroupKeys) group.*member = table.any_number(key).value_or(group.*member);
  return group;
}

}  // namespace

void read_crowd(TableReader& root, Scene& scene) {
  std::vector<TableReader> tables = root.tables("obstacle");
  check_count(root, "obstacle", tables.size(), kMaxObstacles);
  for (TableReader& table : tables) {
    scene.standing.obstacles.push_back(read_obstacle(table));
    table.refuse_unknown_keys();
    check_by(table, "", [&] { check(scene.standing.obstacles.back()); });
  }
  tables = root.tables("wall");
  check_count(root, "wall", tables.size(), kMaxWalls);
  for (TableReader& table : tables) {
    scene.standing.walls.push_back(read_wall(table));
    table.refuse_unknown_keys();
    check_by(table, "", [&] { check(scene.standing.walls.back()); });
  }
  tables = root.tables("goal");
  check_count(root, "goal", tables.size(), kMostGoals);
  std::vector<std::string> names;
  for (TableReader& table : tables) {
    scene.goals.push_back(read_goal(table, names));
    names.push_back(scene.goals.back().name);
    table.refuse_unknown_keys();
  }
  names.clear();
  std::size_t walkers = 0;
  for (TableReader& table : root.tables("walkers")) {
    scene.walkers.push_back(read_group(table, scene.goals, names));
    const WalkerGroup& group = scene.walkers.back();
    names.push_back(group.name);
    table.refuse_unknown_keys();
    check_by(table, "", [&] { check(group); });
    walkers += group.count;
    if (walkers > kMostWalkers)
      table.refuse("count", fmt::format("{} walkers in all", walkers),
                   fmt::format("at most {}", kMostWalkers));
  }
}

}  // namespace prairie
