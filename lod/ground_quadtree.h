// Which patches of ground a frame draws: a quadtree, split where patches are large for their distance,
// neighbours differing by one level at most, so that stitched edges leave no crack.
#pragma once

#include <vector>

#include "generator/meadow.h"
#include "lod/frame_plan.h"
#include "lod/frustum.h"

namespace prairie {

/// Visible patches, front to back. `far_m`: how far the ground is drawn, beyond the map as well.
std::vector<GroundPatch> ground_patches(const Meadow& meadow, const Camera& camera, double far_m);

}  // namespace prairie
