#include "world/motion_keys.h"

#include <algorithm>
#include <numbers>

#include "animation/tread_checks.h"
#include "world/foreign_check.h"
#include "world/point_list.h"
#include "world/scene_names.h"

namespace prairie {
namespace {

// Inside the range of most_tilt_rad (animation/tread_checks.cpp), in degrees that are written down easily.
constexpr Bounds kMostTiltDeg{6.0, 89.9};

struct TreadKey {
  const char* key;  // as the member
  float TreadSettings::*member;
};

constexpr TreadKey kTreadKeys[] = {
    {"field_scale", &TreadSettings::field_scale},   {"load_slowing", &TreadSettings::load_slowing},
    {"worn_slowing", &TreadSettings::worn_slowing}, {"wear_passes", &TreadSettings::wear_passes},
    {"worn_field", &TreadSettings::worn_field},
};

}  // namespace

void read_blade_motion(TableReader& species, BladeMotionSpec& motion) {
  motion.damping_ratio = species.number("damping_ratio", {0.02, 2.0}).value_or(motion.damping_ratio);
  motion.drag_coefficient = species.number("drag_coefficient", {0.0, 2.0}).value_or(motion.drag_coefficient);
}

TreadSettings read_treading(TableReader& table) {
  TreadSettings settings;
  settings.recovery_s = table.any_number("recovery_s").value_or(settings.recovery_s);
  if (const auto tilt_deg = table.number("most_tilt_deg", kMostTiltDeg))
    settings.most_tilt_rad = static_cast<float>(*tilt_deg * std::numbers::pi / 180.0);
  settings.spacing_m = table.any_number("spacing_m").value_or(settings.spacing_m);
  for (const auto& [key, member] : kTreadKeys) {
    // Far beyond every range, but still a float.
    if (const auto value = table.any_number(key))
      settings.*member = static_cast<float>(std::clamp(*value, -1e30, 1e30));
  }
  table.refuse_unknown_keys();
  check_by(table, "treading.", [&] { checked(settings); });
  return settings;
}

MoverSpec read_mover(TableReader& table, const std::vector<std::string>& taken) {
  MoverSpec mover;
  mover.name = read_name(table, taken);
  MoverPath& path = mover.path;
  if (const auto place = table.choice("kind", {"stone", "cart"})) path.kind = static_cast<MoverKind>(*place);
  path.radius_m = table.any_number("radius_m").value_or(path.radius_m);
  path.speed_m_per_s = table.any_number("speed_m_per_s").value_or(path.speed_m_per_s);
  path.start_s = table.any_number("start_s").value_or(path.start_s);
  path.loops = table.flag("loops").value_or(path.loops);
  path.path_m = read_points(table, "path_m", {2, kMaxPathPoints});
  table.refuse_unknown_keys();
  check_by(table, "", [&] { check(path); });
  return mover;
}

}  // namespace prairie
