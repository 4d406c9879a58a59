// The viewer: a window in which a person flies over the meadow or walks through it while it moves, and plays
// with it.
#pragma once

#include "app/viewer/viewer_options.h"
#include "lod/camera.h"

namespace prairie {

class World;

/// Shows the world, which goes on meanwhile, until the window is closed. After a reset of the graphics device
/// it goes on in a new window. Throws NoSuitableOpenGl, OverBudget; LostContext if the first frame in a new
/// window is lost, too.
void view_world(World& world, const Camera& start, const ViewerOptions& options);

}  // namespace prairie
