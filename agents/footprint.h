// What a thing takes up of the ground as seen from above: walkers stay on it, so that they see and avoid one
// another and all else in the plan (G03 §5.1). Deviation: G03 takes bounding boxes in space; on ground that
// nobody leaves they come to this.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <variant>
#include <vector>

#include "agents/driven_mover.h"
#include "agents/mover.h"
#include "agents/plane_vectors.h"

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

/// The same between discs, in closed form.
inline PlanDistance disc_distance(const Disc& from, const Disc& to) {
  const glm::dvec2 way = to.centre_m - from.centre_m;
  return {glm::length(way) - from.radius_m - to.radius_m, unit(way, {1.0, 0.0})};
}

/// Whether all of the box is farther than that from the place.
inline bool is_beyond(const FootprintBox& box, glm::dvec2 position_m, double reach_m) {
  const glm::dvec2 apart =
      glm::max(glm::max(box.low_m - position_m, position_m - box.high_m), glm::dvec2(0.0));
  return glm::dot(apart, apart) > reach_m * reach_m;
}

/// A stone's disc; of a cart the rectangle about its box and wheels.
Footprint footprint_of(MoverKind kind, double radius_m, const MoverPlace& place);

}  // namespace prairie
