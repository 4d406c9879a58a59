// [treading] and [[mover]]: how grass bears what goes over it, and what does.
#include "animation/tread_checks.h"
#include "world/scene/foreign_check.h"
#include "world/scene/name_key.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

// Inside the range of most_tilt_rad (animation/tread_checks.cpp), in degrees that are written down easily.
constexpr Bounds kMostTiltDeg{6.0, 89.9};

void check_treading(const TableReader& table, const TreadSettings& settings) {
  check_by(table, "treading.", [&] { checked(settings); });
}

void check_mover(const TableReader& table, const MoverSpec& mover) {
  check_by(table, "", [&] { check(mover.path); });
}

}  // namespace

// Ranges are those of animation/tread_checks.cpp.
const KeyTable<TreadSettings>& treading_keys() {
  using S = TreadSettings;
  static const KeyTable<S> table{
      {key<&S::recovery_s>({.name = "recovery_s", .hash = {"recovery_s", 2}}),
       key<&S::most_tilt_rad>(
           {.name = "most_tilt_deg", .range = kMostTiltDeg, .unit = Unit::kDegrees, .hash = {"treading", 4}}),
       key<&S::spacing_m>({.name = "spacing_m", .hash = {"spacing_m", 0}}),
       key<&S::reach_radii>({.hash = {"reach_radii", 1}}),
       key<&S::field_scale>({.name = "field_scale", .hash = {"treading", 3}}),
       key<&S::load_slowing>({.name = "load_slowing", .hash = {"treading", 5}}),
       key<&S::worn_slowing>({.name = "worn_slowing", .hash = {"treading", 5}}),
       key<&S::wear_passes>({.name = "wear_passes", .hash = {"treading", 5}}),
       key<&S::worn_field>({.name = "worn_field", .hash = {"treading", 5}})},
      check_treading};
  return table;
}

// Ranges are those of agents/mover.h.
const KeyTable<MoverSpec>& mover_keys() {
  static const KeyTable<MoverSpec> table{
      {name_key<&Scene::movers, &MoverSpec::name>("mover"),
       key<&MoverSpec::path, &MoverPath::kind>(
           {.name = "kind", .words = {"stone", "cart"}, .hash = {"kind"}}),
       key<&MoverSpec::path, &MoverPath::radius_m>({.name = "radius_m", .hash = {"radius_m"}}),
       key<&MoverSpec::path, &MoverPath::speed_m_per_s>({.name = "speed_m_per_s", .hash = {"speed_m_per_s"}}),
       key<&MoverSpec::path, &MoverPath::start_s>({.name = "start_s", .hash = {"start_s"}}),
       key<&MoverSpec::path, &MoverPath::loops>({.name = "loops", .hash = {"loops"}}),
       key<&MoverSpec::path, &MoverPath::path_m>(
           {.name = "path_m", .counts = {2, kMaxPathPoints}, .is_required = true, .hash = {"point_m"}})},
      check_mover};
  return table;
}

}  // namespace prairie
