// The light of a scene: sun and sky as the shaders' light block holds them.
#pragma once

#include "shaders/shared/layouts.h"
#include "world/scene.h"

namespace prairie {

LightParams scene_light(const SunSpec& sun);

}  // namespace prairie
