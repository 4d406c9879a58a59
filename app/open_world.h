// The first step of nearly every command: from a scene folder and the global options to a world.
#pragma once

#include <filesystem>

#include "app/global_options.h"
#include "world/world.h"

namespace prairie {

/// Warnings about the maps go to stderr. Throws BadInput, OverBudget.
World open_world(const std::filesystem::path& folder, const GlobalOptions& globals);

}  // namespace prairie
