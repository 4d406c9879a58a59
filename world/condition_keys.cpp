#include "world/condition_keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "world/foreign_check.h"
#include "world/scene.h"

namespace prairie {
namespace {

constexpr Bounds kPositionM{-1e6, 1e6};
constexpr Bounds kSpeedMPerS{-100.0, 100.0};

struct NumberKey {
  const char* key;  // as the member
  double Condition::*member;
};

// Their ranges are those of animation/condition.h.
constexpr NumberKey kNumberKeys[] = {
    {"start_s", &Condition::start_s},
    {"duration_s", &Condition::duration_s},
    {"fade_s", &Condition::fade_s},
    {"stiffness_factor", &Condition::stiffness_factor},
};

Condition read_condition(TableReader& table) {
  Condition condition;
  if (const auto centre_m = table.pair("centre_m", kPositionM))
    condition.centre_m = {(*centre_m)[0], (*centre_m)[1]};
  if (const auto velocity = table.pair("velocity_m_per_s", kSpeedMPerS))
    condition.velocity_m_per_s = {(*velocity)[0], (*velocity)[1]};
  condition.radius_m = table.any_number("radius_m").value_or(condition.radius_m);
  // A small disc is all edge.
  condition.edge_m = table.any_number("edge_m").value_or(std::min(condition.edge_m, condition.radius_m));
  for (const auto& [key, member] : kNumberKeys)
    condition.*member = table.any_number(key).value_or(condition.*member);
  condition.color_factor = table.color("color_factor", {0.0, 4.0}).value_or(condition.color_factor);
  table.refuse_unknown_keys();
  check_by(table, ": ", [&] { check(condition, ""); });
  return condition;
}

}  // namespace

std::vector<Condition> read_conditions(TableReader& root) {
  std::vector<Condition> conditions;
  for (TableReader& table : root.tables("condition")) {
    if (conditions.size() == kMaxConditions) {
      root.refuse("condition", fmt::format("more than {} conditions", kMaxConditions),
                  fmt::format("at most {}", kMaxConditions));
    }
    conditions.push_back(read_condition(table));
  }
  return conditions;
}

}  // namespace prairie
