// Keys that name a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "world/scene/key_traits.h"
#include "world/scene/scene.h"

namespace prairie {

/// A path, where it is relative from the scene's folder on. Throws BadInput where it is none.
std::optional<std::filesystem::path> read_path(TableReader& table, const KeyTraits& key, const Scene& so_far,
                                               const char* expected);

/// Relative to the scene's folder where it can be.
std::string path_text(const Scene& scene, const std::filesystem::path& file);

}  // namespace prairie
