// What nearly every command is told of its scene. What is set must live as long as the command.
#pragma once

#include <filesystem>
#include <optional>

#include "app/commands/command.h"
#include "generator/tiles.h"

namespace prairie {

/// The argument DIR.
CommandOption scene_folder_option(std::filesystem::path& folder);

/// `--tiles`, of app/scenes/chosen_tiles.h.
CommandOption chosen_tiles_option(std::optional<TileRange>& tiles);

}  // namespace prairie
