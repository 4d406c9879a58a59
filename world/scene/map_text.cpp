#include "world/scene/map_text.h"

#include <fmt/format.h>

#include "world/scene/key_table.h"

namespace prairie {

void hash_map(CanonicalText& text, std::string_view name, const MapSpec& map, MapUse use,
              const ContentHashes& files) {
  text.add("map", std::string(name));
  hash_section(map_keys(use), files, map, text);
}

std::string map_text(const Scene& scene, const MapSpec& map, MapUse use, const MapSpec& defaults) {
  std::string text;
  for (const KeyText& key : section_texts(map_keys(use), scene, map, defaults)) {
    if (!key.is_default) text += fmt::format("{} {} = {}", text.empty() ? "{" : ",", key.name, key.value);
  }
  return text + " }";
}

}  // namespace prairie
