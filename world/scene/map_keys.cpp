// Maps: [height], a species' density, and those in [maps].
#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <cmath>

#include "world/scene/file_key.h"
#include "world/scene/key_ranges.h"
#include "world/scene/scene_keys.h"

namespace prairie {
namespace {

constexpr Bounds kSpacingM{1e-3, 1e4};

constexpr const char* kFile = "the path of an image or raster, or a list of them: a mosaic";

std::filesystem::path path_in_scene(const TableReader& table, const KeyTraits& key, const Scene& so_far,
                                    const toml::node& node) {
  const auto text = node.value<std::string>();
  if (!text || text->empty() || text->find('\0') != std::string::npos) table.refuse(key.name, kFile);
  return so_far.folder / *text;
}

void read_file(TableReader& table, const KeyTraits& key, const Scene& so_far, MapSpec& map) {
  map.field = table.path_of(key.name);
  const toml::node* node = table.node(key.name);
  if (node == nullptr) table.refuse_missing(key.name, kFile);
  const toml::array* list = node->as_array();
  if (list == nullptr) {
    map.file = path_in_scene(table, key, so_far, *node);
    return;
  }
  if (list->empty()) table.refuse(key.name, kFile);
  map.file = path_in_scene(table, key, so_far, *list->get(0));
  for (std::size_t k = 1; k < list->size(); ++k)
    map.more_files.push_back(path_in_scene(table, key, so_far, *list->get(k)));
}

void hash_file(CanonicalText& text, const KeyTraits& key, const ContentHashes& files, const MapSpec& map) {
  if (const auto content = files.find(map.field); content != files.end())
    text.add(key.hash.name, content->second);
}

std::string file_text(const KeyTraits&, const Scene& scene, const MapSpec& map) {
  std::string text = path_text(scene, map.file);
  if (map.more_files.empty()) return text;
  for (const std::filesystem::path& file : map.more_files) text += ", " + path_text(scene, file);
  return "[" + text + "]";
}

void read_size(TableReader& table, const KeyTraits& key, const Scene&, MapSpec& map) {
  const auto size = table.pair(key.name, *key.range);
  if (!size) return;
  for (const double side : *size) {
    if (side != std::floor(side)) table.refuse(key.name, "columns and rows, two whole numbers");
  }
  map.size_px = {static_cast<int>((*size)[0]), static_cast<int>((*size)[1])};
}

void hash_size(CanonicalText& text, const KeyTraits& key, const ContentHashes&, const MapSpec& map) {
  if (map.size_px)
    text.add(key.hash.name, std::array<double, 2>{double((*map.size_px)[0]), double((*map.size_px)[1])});
}

std::string size_text(const KeyTraits&, const Scene&, const MapSpec& map) {
  return map.size_px ? fmt::format("[{}, {}]", (*map.size_px)[0], (*map.size_px)[1]) : "";
}

void read_channel(TableReader& table, const KeyTraits& key, const Scene&, MapSpec& map) {
  read_value(table, key, map.channel);
  if (map.channel && map.channel->empty())
    table.refuse(key.name, "\"R\", \"G\", \"B\", \"A\" or a channel's name");
}

void read_range(TableReader& table, const KeyTraits& key, const Scene&, MapSpec& map) {
  read_value(table, key, map.range);
  if (map.range && (*map.range)[0] == (*map.range)[1])
    table.refuse(key.name, fmt::format("[{0}, {0}]", (*map.range)[0]), "two different numbers");
}

/// All maps are hashed alike; `channel` and so on: the keys' names, empty for those that the map goes
/// without.
KeyTable<MapSpec> table_of(std::string_view channel, std::string_view range, std::string_view scale,
                           std::string_view curve, std::string_view max, Bounds max_range) {
  return {{
      {.traits = {.name = "file", .is_required = true, .hash = {"content", 0}},
       .read = read_file,
       .hash = hash_file,
       .text = file_text},
      key<&MapSpec::spacing_m>({.name = "spacing_m", .range = kSpacingM, .hash = {"spacing_m", 2}}),
      key<&MapSpec::nodata>({.name = "nodata", .range = kAnyNumber, .hash = {"nodata", 4}}),
      key<&MapSpec::crs>({.name = "crs", .hash = {"crs", 8}}),
      {.traits = {.name = "size_px", .range = Bounds{1.0, 1e5}, .hash = {"size_px", 9}},
       .read = read_size,
       .hash = hash_size,
       .text = size_text},
      key<&MapSpec::scale>({.name = scale, .range = Bounds{1e-6, 1e6}, .hash = {"scale", 10}}),
      key<&MapSpec::repeats>({.name = "repeat", .hash = {"repeats", 7}}),
      {.traits = {.name = channel, .hash = {"channel", 1}},
       .read = read_channel,
       .hash = hash_member<MapSpec, &MapSpec::channel>,
       .text = member_text<MapSpec, &MapSpec::channel>},
      {.traits = {.name = range, .range = kAnyNumber, .hash = {"range", 3}},
       .read = read_range,
       .hash = hash_member<MapSpec, &MapSpec::range>,
       .text = member_text<MapSpec, &MapSpec::range>},
      key<&MapSpec::curve>({.name = curve, .range = Bounds{0.01, 100.0}, .hash = {"curve", 5}}),
      key<&MapSpec::max>({.name = max, .range = max_range, .hash = {"max", 6}}),
  }};
}

}  // namespace

MapSpec default_map(const Scene& so_far) {
  MapSpec map;
  map.repeats = so_far.height && so_far.height->repeats;
  return map;
}

const KeyTable<MapSpec>& map_keys(MapUse use) {
  static const KeyTable<MapSpec> tables[] = {
      table_of("channel", "range", "scale", "", "", {}),
      table_of("channel", "range", "", "curve", "max_per_m2", {0.0, kMaxDensityPerM2}),
      table_of("channel", "range", "", "", "max", {0.0, 10.0}),
      table_of("", "", "", "", "", {}),
  };
  return tables[static_cast<std::size_t>(use)];
}

}  // namespace prairie
