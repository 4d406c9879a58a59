// The commented scene.toml that `prairie new` writes: a text to edit, not only to read back.
#pragma once

#include <optional>
#include <string>

#include "app/scenes/new_scene.h"
#include "world/example_meadow.h"

namespace prairie {

/// Names of the example's maps in its folder.
inline constexpr const char* kExampleGroundFile = "ground.tif";
inline constexpr const char* kExampleFescueFile = "fescue.png";
inline constexpr const char* kExampleOatgrassFile = "oatgrass.png";
inline constexpr const char* kExampleBladeHeightFile = "blade_height.png";

std::string example_scene_text(std::uint64_t seed, const ExampleMeadow& meadow);

/// Names of the copies of a person's rasters in the scene's folder; empty where there is none.
struct RasterNames {
  std::string height;
  std::string density;
};

/// Without a camera the text is good for opening the scene, and finding a place for one.
std::string raster_scene_text(const NewSceneRequest& request, const RasterNames& names,
                              const std::optional<CameraSpec>& camera);

/// A group of so many who wander before the camera, and a wall about the ground that keeps them in; nothing
/// for none. Throws UsageError where the ground is too small for them.
std::string walkers_text(std::uint32_t count, const CameraSpec& camera, glm::dvec2 extent_m);

}  // namespace prairie
