// Walls (agents/obstacle.h) as triangles in the scene. One that walkers stay out of is its polygon, as high
// above the ground as it says everywhere. One that they stay within is built along its rings on the side
// where nobody walks: outside of the outer ring, inside of the holes; a hole too narrow for that is solid.
//
// Top and sides: the polygon's convex pieces (agents/convex_pieces.h) are cut along a lattice, so that the
// top follows the ground; the edges that only one triangle has are the outline, and from them the sides go
// down.
#pragma once

#include "agents/obstacle.h"
#include "render/things/shapes/obstacle_mesh.h"

namespace prairie {

inline constexpr double kWallThicknessM = 0.3;

/// The polygons that stand on the ground; none of a wall that is not drawn. Beyond an outer ring that leaves
/// no room for the thickness it is less. Throws BadInput on an outline that convex_pieces() refuses.
std::vector<WallPolygon> standing_polygons(const Wall& wall);

/// Appends.
void add_mesh(const Wall& wall, const HeightField& ground, ObstacleMesh& mesh);

}  // namespace prairie
