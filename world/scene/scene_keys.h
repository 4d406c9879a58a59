// The tables of keys, one for each section of a scene's file (docs/scene-file.md). By them sections are read
// (scene_reader.h), hashed (scene_hash.h), written (scene_text.h) and overridden, and the manual is checked.
// A new key is a new row; a key that no member's type alone describes has functions of its own in its row.
#pragma once

#include <string_view>

#include "world/scene/key.h"
#include "world/scene/scene.h"

namespace prairie {

/// Those of the file itself, without its version.
const KeyTable<Scene>& top_keys();
const KeyTable<Scene>& ground_keys();
/// What a map is for decides which keys it has.
enum class MapUse { kHeight, kDensity, kFactor, kColor };
const KeyTable<MapSpec>& map_keys(MapUse use);
const KeyTable<SpeciesSpec>& species_keys();
const KeyTable<CameraSpec>& camera_keys();
const KeyTable<SunSpec>& sun_keys();
const KeyTable<SunSpec>& sky_keys();
const KeyTable<LodSpec>& lod_keys();
const KeyTable<WindSpec>& wind_keys();
const KeyTable<Gust>& gust_keys();
const KeyTable<Tornado>& tornado_keys();
const KeyTable<Breeze>& breeze_keys();
const KeyTable<Condition>& condition_keys();
const KeyTable<TreadSettings>& treading_keys();
const KeyTable<MoverSpec>& mover_keys();
/// Of obstacles but their kind.
const KeyTable<Trunk>& trunk_keys();
const KeyTable<Block>& box_keys();
const KeyTable<Rock>& rock_keys();
const KeyTable<Wall>& wall_keys();
const KeyTable<GoalSpec>& goal_keys();
const KeyTable<WalkerGroup>& walkers_keys();

/// What a map is where its table says nothing: it repeats with the height map.
MapSpec default_map(const Scene& so_far);
/// The same of a species: a fescue.
SpeciesSpec default_species();

// Of what is one of several kinds: its table, and the name of its kind in the file.
inline const KeyTable<Gust>& keys_of(const Gust&) {
  return gust_keys();
}
inline const KeyTable<Tornado>& keys_of(const Tornado&) {
  return tornado_keys();
}
inline const KeyTable<Breeze>& keys_of(const Breeze&) {
  return breeze_keys();
}
inline const KeyTable<Trunk>& keys_of(const Trunk&) {
  return trunk_keys();
}
inline const KeyTable<Block>& keys_of(const Block&) {
  return box_keys();
}
inline const KeyTable<Rock>& keys_of(const Rock&) {
  return rock_keys();
}
inline const char* kind_name(const Gust&) {
  return "gust";
}
inline const char* kind_name(const Tornado&) {
  return "tornado";
}
inline const char* kind_name(const Breeze&) {
  return "breeze";
}
inline const char* kind_name(const Trunk&) {
  return "trunk";
}
inline const char* kind_name(const Block&) {
  return "box";
}
inline const char* kind_name(const Rock&) {
  return "rock";
}

}  // namespace prairie
