#include "agents/footprint.h"

#include <glm/common.hpp>

#include "agents/gjk.h"

namespace prairie {
namespace {

// Of a cart of half width 1 (agents/mover.cpp): its box, and the wheels that stand out beside it.
constexpr glm::dvec2 kCartHalfSize(1.6, 1.12);

}  // namespace

FootprintBox box_of(const Footprint& footprint) {
  if (const auto* disc = std::get_if<Disc>(&footprint))
    return {disc->centre_m - disc->radius_m, disc->centre_m + disc->radius_m};
  const std::vector<glm::dvec2>& points_m = std::get<Outline>(footprint).points_m;
  FootprintBox box{points_m.front(), points_m.front()};
  for (const glm::dvec2 point_m : points_m) {
    box.low_m = glm::min(box.low_m, point_m);
    box.high_m = glm::max(box.high_m, point_m);
  }
  return box;
}

PlanDistance plan_distance(const Disc& from, const Footprint& to) {
  const SphereShape<2, double> disc{from.centre_m, from.radius_m};
  if (const auto* other = std::get_if<Disc>(&to)) {
    const auto found = shape_distance(disc, SphereShape<2, double>{other->centre_m, other->radius_m});
    return {found.distance_m, found.normal};
  }
  const auto found = shape_distance(disc, ConvexVertices<2, double>{std::get<Outline>(to).points_m});
  return {found.distance_m, found.normal};
}

Footprint footprint_of(MoverKind kind, double radius_m, const MoverPlace& place) {
  if (kind == MoverKind::kStone) return Disc{glm::dvec2(place.centre_m), radius_m};
  const glm::dvec2 ahead = kCartHalfSize.x * radius_m * glm::dvec2(place.axes[0]);
  const glm::dvec2 aside = kCartHalfSize.y * radius_m * glm::dvec2(place.axes[1]);
  const glm::dvec2 centre_m(place.centre_m);
  return Outline{{centre_m - ahead - aside, centre_m + ahead - aside, centre_m + ahead + aside,
                  centre_m - ahead + aside}};
}

}  // namespace prairie
