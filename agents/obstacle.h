// What stands in a meadow and in the way of walkers (G03 §5.1): trunks, boxes, rocks, and virtual walls that
// keep walkers in an area or out of it. What is drawn of them is what walkers see.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

#include "agents/convex_hull.h"
#include "agents/convex_pieces.h"
#include "agents/footprint.h"
#include "maps/height_field.h"

namespace prairie {

/// Upright, on the ground; the top is rounded.
struct Trunk {
  glm::dvec2 position_m{0.0};
  double radius_m = 0.2;  // 0.02…5
  double height_m = 3.0;  // 0.1…100
};

/// Upright, on the ground's lowest point below it.
struct Block {
  glm::dvec2 position_m{0.0};  // of its middle
  glm::dvec3 size_m{1.0};      // ahead, across, up; 0.02…1000
  double heading_rad = 0.0;    // from east, counter-clockwise
};

/// The convex hull of points strewn over an ellipsoid, a third of it in the ground.
struct Rock {
  glm::dvec2 position_m{0.0};
  glm::dvec3 size_m{1.0};  // ahead, across, up; 0.05…50
  double heading_rad = 0.0;
  std::uint32_t seed = 1;
};

using Obstacle = std::variant<Trunk, Block, Rock>;

/// Which side of a wall's outline walkers are on.
enum class WallSide { kInside, kOutside };

/// Inside: walkers stay within the outer ring and out of the holes. Outside: the polygon itself is solid, its
/// holes are free.
struct Wall {
  WallPolygon outline;
  WallSide walkers = WallSide::kInside;
  double height_m = 0.0;  // as drawn, 0…100; 0: not at all
};

/// All that stands in a scene.
struct StandingThings {
  std::vector<Obstacle> obstacles;
  std::vector<Wall> walls;
};

/// Throws BadInput, the field in it, on a number that is not finite or out of range, or an outline that
/// convex_pieces() refuses.
void check(const Obstacle& obstacle);
void check(const Wall& wall);

/// Where an obstacle stands, in the scene's metres.
struct PlacedBlock {
  glm::dvec3 centre_m{0.0};
  glm::dmat3 axes{1.0};  // unit columns ahead, across, up
  glm::dvec3 half_size_m{0.5};
};
PlacedBlock placed(const Block& block, const HeightField& ground);

/// In its own frame: X ahead, Z up, the origin on the ground.
ConvexHull hull_of(const Rock& rock);
/// Of that frame.
struct RockFrame {
  glm::dvec3 origin_m{0.0};
  glm::dmat3 axes{1.0};
};
RockFrame placed(const Rock& rock, const HeightField& ground);

/// The ground that they take; of a wall all that walkers are kept out of, as far as `kWallReachM` beyond an
/// enclosure.
Footprint footprint_of(const Obstacle& obstacle, const HeightField& ground);
std::vector<Footprint> footprints_of(const Wall& wall);
inline constexpr double kWallReachM = 25.0;
std::vector<Footprint> footprints_of(const StandingThings& things, const HeightField& ground);

}  // namespace prairie
