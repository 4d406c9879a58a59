// What of a scene is probably not meant as it stands: goals, starts and paths beside the ground or inside
// something, maps of which hardly a part lies on it. Each with its place and what to do.
#pragma once

#include <vector>

#include "files/warning.h"
#include "generator/meadow.h"
#include "world/map_loading.h"
#include "world/scene/scene.h"

namespace prairie {

/// Nothing of a ground that repeats lies beside it.
std::vector<Warning> suspicions_of(const Scene& scene, const Meadow& meadow,
                                   const std::vector<LoadedMap>& maps);

}  // namespace prairie
