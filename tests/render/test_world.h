// Worlds for pictures: maps written to a folder that lives as long as the test.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>

#include "lod/camera.h"
#include "tests/temporary_folder.h"
#include "world/world.h"

namespace prairie {

/// A map of nodes `spacing_m` apart over extent_m × extent_m, written as a GeoTIFF without a place on Earth.
MapSpec write_map(const TemporaryFolder& folder, const char* name, double extent_m, double spacing_m,
                  const std::function<double(glm::dvec2)>& value);

/// 32 m × 32 m of rolling ground, two species in drifts, a bare round in the middle of the eastern half.
Scene meadow_scene(const TemporaryFolder& folder);

/// Rough bare ground in a light that makes it black under a blinding sky: every hole shows.
Scene dark_ground_scene(const TemporaryFolder& folder, bool repeats);

World open_world(Scene scene);

/// A camera `above_m` the world's ground.
Camera camera_above(const World& world, glm::dvec2 position_m, double above_m, double yaw_rad,
                    double pitch_rad);

}  // namespace prairie
