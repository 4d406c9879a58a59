// A scene small enough that any command on it takes moments: 16 × 16 m, one species, at most 100 blades per
// m², gentle ground.
#pragma once

#include <filesystem>
#include <string>

namespace prairie::testing {

inline constexpr int kSmallSceneTiles = 4;  // per side

/// The text of its scene.toml, for tests that change a line of it.
std::string small_scene_toml();

/// Writes scene.toml, ground.tif and density.png into `folder`, which is made where it is missing.
void write_small_scene(const std::filesystem::path& folder);

}  // namespace prairie::testing
