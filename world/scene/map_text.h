// A whole map within another section: as a line of the hashed text, and as an inline table of TOML.
#pragma once

#include <string>
#include <string_view>

#include "world/scene/canonical_text.h"
#include "world/scene/scene_hash.h"
#include "world/scene/scene_keys.h"

namespace prairie {

/// `name`: what the map is of.
void hash_map(CanonicalText& text, std::string_view name, const MapSpec& map, MapUse use,
              const ContentHashes& files);

/// { file = "…", … }, without what is as in `defaults`.
std::string map_text(const Scene& scene, const MapSpec& map, MapUse use, const MapSpec& defaults);

}  // namespace prairie
