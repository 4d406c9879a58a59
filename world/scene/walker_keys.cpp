// [[goal]] and [[walkers]].
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>

#include "world/scene/foreign_check.h"
#include "world/scene/key_ranges.h"
#include "world/scene/key_table.h"
#include "world/scene/name_key.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

/// The goals of those names, in their order.
void read_goals(TableReader& table, const KeyTraits& key, const Scene& so_far, WalkerGroup& group) {
  const toml::node* value = table.node(key.name);
  if (value == nullptr) return;
  const std::string expected = "names of [[goal]]s";
  const auto* list = value->as_array();
  if (list == nullptr || list->size() > kMostGoals) table.refuse(key.name, expected);
  for (const toml::node& element : *list) {
    const auto name = element.value<std::string>();
    const auto found =
        std::ranges::find_if(so_far.goals, [&](const GoalSpec& one) { return name && one.name == *name; });
    if (found == so_far.goals.end()) table.refuse(key.name, name ? printable(*name) : "no text", expected);
    group.goals.push_back(found->goal);
  }
}

void hash_goals(CanonicalText& text, const KeyTraits&, const ContentHashes& files, const WalkerGroup& group) {
  for (const Goal& goal : group.goals) hash_section(goal_keys(), files, GoalSpec{"", goal}, text);
}

std::string goals_text(const KeyTraits&, const Scene& scene, const WalkerGroup& group) {
  std::vector<std::string> names;
  for (const Goal& goal : group.goals) {
    const auto found =
        std::ranges::find_if(scene.goals, [&](const GoalSpec& one) { return one.goal == goal; });
    if (found != scene.goals.end()) names.push_back(quoted_text(found->name));
  }
  return names.empty() ? std::string() : fmt::format("[{}]", fmt::join(names, ", "));
}

std::string count_text(const KeyTraits& key, const Scene&, const WalkerGroup& group) {
  return group.starts_m.empty() ? value_text(key, group.count) : std::string();
}

void read_starts(TableReader& table, const KeyTraits& key, const Scene&, WalkerGroup& group) {
  read_value(table, key, group.starts_m);
  if (!group.starts_m.empty()) group.count = static_cast<std::uint32_t>(group.starts_m.size());
}

/// Needed where walkers have no places of their own, unknown where they have.
void read_centre(TableReader& table, const KeyTraits& key, const Scene&, WalkerGroup& group) {
  if (group.starts_m.empty()) read_value(table, key, group.centre_m);
}

std::string centre_text(const KeyTraits& key, const Scene&, const WalkerGroup& group) {
  return group.starts_m.empty() ? value_text(key, group.centre_m) : std::string();
}

void check_group(const TableReader& table, const WalkerGroup& group) {
  check_by(table, "", [&] { check(group); });
}

/// Its range is that of agents/crowd_spec.h.
template <auto parameter>
Key<WalkerGroup> parameter_key(std::string_view name) {
  return key<parameter>({.name = name, .hash = {"parameter", 3}});
}

}  // namespace

const KeyTable<GoalSpec>& goal_keys() {
  static const KeyTable<GoalSpec> table{{
      // Goals are hashed with the walkers who go there, whatever they are called.
      name_key<&Scene::goals, &GoalSpec::name>({}),
      key<&GoalSpec::goal, &Goal::position_m>(
          {.name = "position_m", .range = kPositionM, .is_required = true, .hash = {"goal"}}),
      key<&GoalSpec::goal, &Goal::radius_m>(
          {.name = "radius_m", .range = Bounds{0.2, 1e4}, .hash = {"radius_m"}}),
      key<&GoalSpec::goal, &Goal::stay_s>({.name = "stay_s", .range = Bounds{0.0, 1e9}, .hash = {"stay_s"}}),
  }};
  return table;
}

const KeyTable<WalkerGroup>& walkers_keys() {
  using G = WalkerGroup;
  static const KeyTable<G> table{
      {name_key<&Scene::walkers, &G::name>("walkers"),
       {.traits = {.name = "count", .hash = {"count"}},
        .read = read_member<G, &G::count>,
        .hash = hash_member<G, &G::count>,
        .text = count_text},
       key<&G::behaviour>({.name = "behaviour", .hash = {"behaviour"}}),
       {.traits = {.name = "goals", .hash = {"goal"}},
        .read = read_goals,
        .hash = hash_goals,
        .text = goals_text},
       {.traits = {.name = "starts_m", .counts = {1, kMostWalkers}, .hash = {"start_m", 2}},
        .read = read_starts,
        .hash = hash_member<G, &G::starts_m>,
        .text = member_text<G, &G::starts_m>},
       {.traits = {.name = "position_m", .range = kPositionM, .is_required = true, .hash = {"centre_m", 1}},
        .read = read_centre,
        .hash = hash_member<G, &G::centre_m>,
        .text = centre_text},
       parameter_key<&G::radius_m>("radius_m"),
       parameter_key<&G::speed_m_per_s>("speed_m_per_s"),
       parameter_key<&G::speed_spread>("speed_spread"),
       parameter_key<&G::height_m>("height_m"),
       parameter_key<&G::height_spread>("height_spread"),
       parameter_key<&G::body_radius_m>("body_radius_m"),
       parameter_key<&G::sensor_m>("sensor_m"),
       parameter_key<&G::noise>("noise")},
      check_group};
  return table;
}

}  // namespace prairie
