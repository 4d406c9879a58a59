// Where a map lies in the scene: the scene's origin is the south-west node of the map that the ground comes
// from, and maps of other resolutions and extents keep their places relative to it.
#pragma once

#include <glm/vec2.hpp>

#include "maps/map_file.h"

namespace prairie {

/// Position of `map`'s south-west node in a scene whose origin is `reference`'s south-west node.
glm::dvec2 origin_in_scene_m(const GeoReference& map, const GeoReference& reference);

/// The same nodes, the south-west one at `origin_m`.
NodeGrid placed_at(NodeGrid grid, glm::dvec2 origin_m);

/// Share of the box (0, 0)…extent_m that the grid covers, 0…1. A node stands for half a spacing around
/// itself, so that grids of different resolutions cut from the same area cover one another.
double covered_share(const GridFrame& frame, glm::dvec2 extent_m);

}  // namespace prairie
