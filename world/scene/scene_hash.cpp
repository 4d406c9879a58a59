#include "world/scene/scene_hash.h"

#include <xxhash.h>

#include <optional>
#include <string_view>
#include <variant>

#include "world/scene/canonical_text.h"
#include "world/scene/key_table.h"
#include "world/scene/map_text.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

/// The scene as text. Its sections come in the order in which it came to have them.
class SceneText {
 public:
  SceneText(const ContentHashes& files, CanonicalText& text) : files_(files), text_(text) {}

  template <class Section>
  void add(const KeyTable<Section>& keys, const Section& section) {
    hash_section(keys, files_, section, text_);
  }
  template <class Section>
  void add(const KeyTable<Section>& keys, const std::vector<Section>& sections) {
    for (const Section& section : sections) add(keys, section);
  }
  void add(std::string_view name, const std::optional<MapSpec>& map, MapUse use) {
    if (map) hash_map(text_, name, *map, use, files_);
  }
  template <class... Kinds>
  void add(const std::variant<Kinds...>& thing) {
    std::visit([&](const auto& kind) { add(keys_of(kind), kind); }, thing);
  }

 private:
  const ContentHashes& files_;
  CanonicalText& text_;
};

}  // namespace

std::uint64_t scene_hash(const Scene& scene, const ContentHashes& files) {
  CanonicalText canonical;
  SceneText text(files, canonical);
  text.add(top_keys(), scene);
  text.add(ground_keys(), scene);
  text.add("height", scene.height, MapUse::kHeight);
  text.add(species_keys(), scene.species);
  text.add("blade_height", scene.blade_height, MapUse::kFactor);
  text.add("bend", scene.bend, MapUse::kFactor);
  text.add("color", scene.color, MapUse::kColor);
  text.add(camera_keys(), scene.cameras);
  text.add(sun_keys(), scene.sun);
  text.add(sky_keys(), scene.sun);
  text.add(lod_keys(), scene.lod);
  if (scene.wind) {
    text.add(wind_keys(), *scene.wind);
    for (const WindPrimitive& primitive : scene.wind->primitives) text.add(primitive);
  }
  text.add(condition_keys(), scene.conditions);
  text.add(treading_keys(), scene.treading);
  text.add(mover_keys(), scene.movers);
  for (const Obstacle& obstacle : scene.standing.obstacles) text.add(obstacle);
  text.add(wall_keys(), scene.standing.walls);
  text.add(walkers_keys(), scene.walkers);
  return canonical.hash();
}

std::uint64_t motion_hash(const Scene& scene, const ContentHashes& files) {
  Scene unseen = scene;
  unseen.cameras.clear();
  unseen.sun = SunSpec{};
  unseen.lod = LodSpec{};
  return scene_hash(unseen, files);
}

std::uint64_t motion_hash_with(std::uint64_t motion_hash, const Gait& gait) {
  CanonicalText text;
  text.add("scene", motion_hash);
  for (const double value : {gait.speed_m_per_s, gait.period_s, gait.stance, gait.lead, gait.half_width})
    text.add("gait", value);
  for (const auto& curve : gait.keys) {
    for (const double key : curve) text.add("key", key);
  }
  return text.hash();
}

std::uint64_t motion_hash_with(std::uint64_t motion_hash, const std::vector<Track>& tracks) {
  CanonicalText text;
  text.add("scene", motion_hash);
  for (const Track& track : tracks) {
    text.add("track", static_cast<std::uint64_t>(track.id));
    text.add("times",
             std::uint64_t{XXH3_64bits(track.times_s.data(), track.times_s.size() * sizeof(double))});
    text.add("places", std::uint64_t{XXH3_64bits(track.positions_m.data(),
                                                 track.positions_m.size() * sizeof(glm::dvec2))});
  }
  return text.hash();
}

}  // namespace prairie
