// From a parsed TOML table to a Scene: which keys a scene file has and what they mean.
#pragma once

#include <toml++/toml.h>

#include <filesystem>

#include "world/scene.h"
#include "world/toml_reader.h"

namespace prairie {

/// Throws BadInput. The paths of maps become `folder` / path where they are relative.
Scene scene_from_table(const toml::table& table, const TomlOrigin& origin,
                       const std::filesystem::path& folder);

}  // namespace prairie
