// The first step of nearly every command: from a scene folder and the global options to a world.
#pragma once

#include <filesystem>
#include <optional>

#include "agents/gait.h"
#include "app/terminal/global_options.h"

namespace prairie {

class World;

/// Warnings about the maps go to stderr. Throws BadInput, OverBudget.
/// `gait`: of its walkers, instead of the one that comes along.
World open_world(const std::filesystem::path& folder, const GlobalOptions& globals,
                 std::optional<Gait> gait = {});

}  // namespace prairie
