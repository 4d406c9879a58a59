#include "world/scene/scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <variant>
#include <vector>

#include "world/scene/key_table.h"
#include "world/scene/map_text.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

class SceneWriter {
 public:
  SceneWriter(const Scene& scene, const SceneNotes& notes) : scene_(scene), notes_(notes) {}

  void head() {
    text_ = notes_.head;
    line("", "version", fmt::format("{}", kSceneVersion));
    lines("", section_texts(top_keys(), scene_, scene_, Scene{}));
  }

  /// [name], where it has anything to say.
  template <class Section>
  void one(const std::string& name, const KeyTable<Section>& keys, const Section& section,
           const Section& defaults = {}) {
    const auto texts = section_texts(keys, scene_, section, defaults);
    const bool says_something =
        std::ranges::any_of(texts, [&](const KeyText& key) { return is_written(name, key); });
    if (!says_something) return;
    heading(name, "[" + name + "]");
    lines(name, texts);
    finish(name);
  }

  /// [[name]]; `first` comes before its keys, where it is not empty.
  template <class Section>
  void one_of_several(const std::string& name, const KeyTable<Section>& keys, const Section& section,
                      const Section& defaults = {}, const std::string& first = {}) {
    heading(name, "[[" + name + "]]");
    text_ += first;
    lines(name, section_texts(keys, scene_, section, defaults));
    finish(name);
  }

  template <class Section>
  void several(const std::string& name, const KeyTable<Section>& keys, const std::vector<Section>& sections,
               const Section& defaults = {}) {
    for (const Section& section : sections) one_of_several(name, keys, section, defaults);
  }

  void maps() {
    if (!scene_.blade_height && !scene_.bend && !scene_.color) return;
    heading("maps", "[maps]");
    map_line("blade_height", scene_.blade_height, MapUse::kFactor);
    map_line("bend", scene_.bend, MapUse::kFactor);
    map_line("color", scene_.color, MapUse::kColor);
    finish("maps");
  }

  void wind() {
    if (!scene_.wind) return;
    WindSpec defaults;
    if (scene_.wind->file) defaults.turbulence = 0.0;
    heading("wind", "[wind]");
    lines("wind", section_texts(wind_keys(), scene_, *scene_.wind, defaults));
    finish("wind");
    const auto write = [&](const auto& kind) {
      one_of_several(fmt::format("wind.{}", kind_name(kind)), keys_of(kind), kind);
    };
    for (const WindPrimitive& primitive : scene_.wind->primitives) std::visit(write, primitive);
  }

  void obstacle(const Obstacle& obstacle) {
    const auto write = [&](const auto& kind) {
      one_of_several("obstacle", keys_of(kind), kind, {}, fmt::format("kind = \"{}\"\n", kind_name(kind)));
    };
    std::visit(write, obstacle);
  }

  std::string take() { return std::move(text_); }

 private:
  static std::string path_of(const std::string& section, std::string_view key) {
    return section.empty() ? std::string(key) : fmt::format("{}.{}", section, key);
  }

  /// The note at that place, unless the section has been written before.
  const std::string* note(const std::map<std::string, std::string>& notes, const std::string& section,
                          const std::string& path) const {
    const auto found = notes.find(path);
    return found == notes.end() || done_.contains(section) ? nullptr : &found->second;
  }

  bool is_written(const std::string& section, const KeyText& key) const {
    return !key.is_default || note(notes_.keys, section, path_of(section, key.name)) != nullptr;
  }

  void heading(const std::string& section, const std::string& line) {
    text_ += '\n';
    if (const auto* above = note(notes_.sections, section, section)) text_ += *above;
    text_ += line + '\n';
  }

  void line(const std::string& section, std::string_view key, const std::string& value) {
    constexpr std::size_t kNoteColumn = 24;
    const std::string path = path_of(section, key);
    if (const auto* above = note(notes_.above, section, path)) text_ += *above;
    std::string line = fmt::format("{} = {}", key, value);
    const auto* behind = note(notes_.keys, section, path);
    if (behind != nullptr && !behind->empty()) {
      line.resize(std::max(kNoteColumn, line.size() + 2), ' ');
      line += "# " + *behind;
    }
    text_ += line + '\n';
  }

  void lines(const std::string& section, const std::vector<KeyText>& keys) {
    for (const KeyText& key : keys) {
      if (is_written(section, key)) line(section, key.name, key.value);
    }
  }

  void map_line(std::string_view name, const std::optional<MapSpec>& map, MapUse use) {
    if (map) line("maps", name, map_text(scene_, *map, use, default_map(scene_)));
  }

  void finish(const std::string& section) {
    if (const auto* below = note(notes_.below, section, section)) text_ += *below;
    done_.insert(section);
  }

  const Scene& scene_;
  const SceneNotes& notes_;
  std::set<std::string> done_;
  std::string text_;
};

}  // namespace

std::string scene_text(const Scene& scene, const SceneNotes& notes) {
  SceneWriter writer(scene, notes);
  writer.head();
  if (scene.height) writer.one("height", map_keys(MapUse::kHeight), *scene.height);
  writer.one("ground", ground_keys(), scene);
  writer.several("species", species_keys(), scene.species, default_species());
  writer.maps();
  writer.several("camera", camera_keys(), scene.cameras);
  writer.one("sun", sun_keys(), scene.sun);
  writer.one("sky", sky_keys(), scene.sun);
  writer.one("lod", lod_keys(), scene.lod);
  writer.wind();
  writer.several("condition", condition_keys(), scene.conditions);
  writer.one("treading", treading_keys(), scene.treading);
  writer.several("mover", mover_keys(), scene.movers);
  for (const Obstacle& obstacle : scene.standing.obstacles) writer.obstacle(obstacle);
  writer.several("wall", wall_keys(), scene.standing.walls);
  writer.several("goal", goal_keys(), scene.goals);
  writer.several("walkers", walkers_keys(), scene.walkers);
  return writer.take();
}

}  // namespace prairie
