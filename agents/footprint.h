// What a thing takes up of the ground as seen from above: walkers stay on it, so that they see and avoid one
// another and all else in the plan (G03 §5.1). Deviation: G03 takes bounding boxes in space; on ground that
// nobody leaves they come to this.
#pragma once

#include <glm/vec2.hpp>
#include <variant>
#include <vector>

#include "agents/driven_mover.h"
#include "agents/mover.h"

namespace prairie {

struct Disc {
  glm::dvec2 centre_m{0.0};
  double radius_m = 0.0;
};

/// The hull of points, in whichever order they come.
struct Outline {
  std::vector<glm::dvec2> points_m;
};

using Footprint = std::variant<Disc, Outline>;

struct FootprintBox {
  glm::dvec2 low_m{0.0}, high_m{0.0};
};
FootprintBox box_of(const Footprint& footprint);

/// From a disc to what is nearest of a footprint, by GJK (agents/gjk.h).
struct PlanDistance {
  double distance_m = 0.0;      // between the edges; negative where they overlap: the shortest way out
  glm::dvec2 toward{1.0, 0.0};  // unit, from the disc to the footprint
};
PlanDistance plan_distance(const Disc& from, const Footprint& to);

/// A stone's disc; of a cart the rectangle about its box and wheels.
Footprint footprint_of(MoverKind kind, double radius_m, const MoverPlace& place);

}  // namespace prairie
