// From a parsed TOML table to a Scene, by the tables of keys.
#pragma once

#include <filesystem>

#include "world/scene/scene.h"
#include "world/scene/toml_reader.h"

namespace prairie {

/// Throws BadInput. The paths of maps become `folder` / path where they are relative.
Scene scene_from_table(const toml::table& table, const TomlOrigin& origin,
                       const std::filesystem::path& folder);

}  // namespace prairie
