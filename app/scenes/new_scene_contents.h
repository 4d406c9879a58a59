// What scenes hold that `prairie new` makes.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "app/scenes/new_scene.h"
#include "world/example_meadow.h"
#include "world/scene/scene.h"

namespace prairie {

/// Names of the example's maps in its folder.
inline constexpr const char* kExampleGroundFile = "ground.tif";
inline constexpr const char* kExampleFescueFile = "fescue.png";
inline constexpr const char* kExampleOatgrassFile = "oatgrass.png";
inline constexpr const char* kExampleBladeHeightFile = "blade_height.png";

Scene example_scene(const NewSceneRequest& request, const ExampleMeadow& meadow);

/// Names of the copies of a person's rasters in the scene's folder; empty where there is none.
struct RasterNames {
  std::vector<std::string> heights;
  std::string density;
};

/// Without cameras.
Scene raster_scene(const NewSceneRequest& request, const RasterNames& names);

/// A group of so many who wander before the scene's first camera, and a wall about the ground that keeps them
/// in; nothing for none. Throws UsageError where the ground is too small for them.
void add_walkers(Scene& scene, std::uint32_t count, glm::dvec2 extent_m);

}  // namespace prairie
