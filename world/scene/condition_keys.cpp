// [[condition]]: what has come over the grass of a place.
#include <algorithm>

#include "world/scene/foreign_check.h"
#include "world/scene/key_ranges.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

constexpr Bounds kSpeedMPerS{-100.0, 100.0};

void read_edge(TableReader& table, const KeyTraits& key, const Scene&, Condition& condition) {
  // A small disc is all edge.
  condition.edge_m = std::min(condition.edge_m, condition.radius_m);
  read_value(table, key, condition.edge_m);
}

void check_condition(const TableReader& table, const Condition& condition) {
  check_by(table, ": ", [&] { check(condition, ""); });
}

/// Its range is that of animation/condition.h.
template <auto parameter>
Key<Condition> parameter_key(std::string_view name) {
  return key<parameter>({.name = name, .hash = {"parameter"}});
}

}  // namespace

const KeyTable<Condition>& condition_keys() {
  static const KeyTable<Condition> table{
      {key<&Condition::centre_m>({.name = "centre_m", .range = kPositionM, .hash = {"condition"}}),
       key<&Condition::velocity_m_per_s>(
           {.name = "velocity_m_per_s", .range = kSpeedMPerS, .hash = {"velocity_m_per_s"}}),
       parameter_key<&Condition::radius_m>("radius_m"),
       {.traits = {.name = "edge_m", .hash = {"parameter"}},
        .read = read_edge,
        .hash = hash_member<Condition, &Condition::edge_m>,
        .text = member_text<Condition, &Condition::edge_m>},
       parameter_key<&Condition::start_s>("start_s"),
       parameter_key<&Condition::duration_s>("duration_s"),
       parameter_key<&Condition::fade_s>("fade_s"),
       parameter_key<&Condition::stiffness_factor>("stiffness_factor"),
       key<&Condition::color_factor>(
           {.name = "color_factor", .range = Bounds{0.0, 4.0}, .hash = {"color_factor"}})},
      check_condition};
  return table;
}

}  // namespace prairie
