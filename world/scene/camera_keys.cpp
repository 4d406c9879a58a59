// [[camera]].
#include <fmt/format.h>
#include <toml++/toml.h>

#include <charconv>

#include "world/scene/key_ranges.h"
#include "world/scene/name_key.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

constexpr const char* kExpected = "[x, y, z] in metres, z as a text \"+1.7\" for above the ground";

/// "+1.7", "-0.25": above the ground.
void read_relative_height(const TableReader& table, std::string_view key, const std::string& z,
                          CameraSpec& camera) {
  const char* end = z.data() + z.size();
  const bool has_sign = z.size() > 1 && (z[0] == '+' || z[0] == '-') && z[1] != '-';
  const auto parsed = has_sign ? std::from_chars(z.data() + 1, end, camera.z_m) : std::from_chars_result{};
  if (!has_sign || parsed.ec != std::errc() || parsed.ptr != end || !(camera.z_m <= kPositionM.max))
    table.refuse(key, fmt::format("z as \"{}\"", printable(z)), kExpected);
  if (z[0] == '-') camera.z_m = 0.0 - camera.z_m;
}

// [x, y, z] with z as a number (absolute) or as text (above the ground).
void read_position(TableReader& table, const KeyTraits& key, const Scene&, CameraSpec& camera) {
  const toml::node* value = table.node(key.name);
  if (value == nullptr) table.refuse_missing(key.name, kExpected);
  const auto* list = value->as_array();
  if (list == nullptr || list->size() != 3) table.refuse(key.name, kExpected);
  camera.position_m.x = table.checked_number(key.name, (*list)[0], kPositionM);
  camera.position_m.y = table.checked_number(key.name, (*list)[1], kPositionM);
  const auto* relative = (*list)[2].as_string();
  camera.z_above_ground = relative != nullptr;
  if (relative != nullptr) {
    read_relative_height(table, key.name, relative->get(), camera);
  } else {
    camera.z_m = table.checked_number(key.name, (*list)[2], kPositionM);
  }
}

void hash_position(CanonicalText& text, const KeyTraits& key, const ContentHashes&,
                   const CameraSpec& camera) {
  text.add(key.hash.name, camera.position_m);
  text.add("z_m", camera.z_m);
  text.add("z_above_ground", camera.z_above_ground);
}

std::string position_text(const KeyTraits&, const Scene&, const CameraSpec& camera) {
  const std::string z = camera.z_above_ground ? fmt::format("\"{:+}\"", camera.z_m) : number_text(camera.z_m);
  return fmt::format("[{}, {}, {}]", number_text(camera.position_m.x), number_text(camera.position_m.y), z);
}

}  // namespace

const KeyTable<CameraSpec>& camera_keys() {
  static const KeyTable<CameraSpec> table{{
      name_key<&Scene::cameras, &CameraSpec::name>("camera"),
      {.traits = {.name = "position_m", .is_required = true, .hash = {"position_m"}},
       .read = read_position,
       .hash = hash_position,
       .text = position_text},
      key<&CameraSpec::yaw_deg>({.name = "yaw_deg", .range = kBearingDeg, .hash = {"yaw_deg"}}),
      key<&CameraSpec::pitch_deg>({.name = "pitch_deg", .range = Bounds{-90.0, 90.0}, .hash = {"pitch_deg"}}),
      key<&CameraSpec::fov_deg>({.name = "fov_deg", .range = Bounds{1.0, 170.0}, .hash = {"fov_deg"}}),
  }};
  return table;
}

}  // namespace prairie
