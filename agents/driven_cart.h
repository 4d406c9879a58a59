// A cart that a person drives: a bicycle model without slip. The hind axle's middle goes where the cart
// points; with wheelbase L and the front wheels turned by δ the heading changes by tan δ / L per metre:
//
//   dθ/ds = tan δ / L,   exactly along an arc over a step
//
// Pure functions of a plain state. Whatever the controls, numbers stay finite and in the ranges given here.
#pragma once

#include <glm/vec2.hpp>

#include "agents/mover.h"
#include "maps/height_field.h"

namespace prairie {

/// What the driver wants, each −1…1; more is taken as that, and what is no number as 0.
struct CartControls {
  double drive = 0.0;  // 1 pulls ahead; −1 brakes, and from standing backs
  double steer = 0.0;  // to the left
};

struct DrivenCart {
  double half_width_m = 0.6;   // 0.05…3
  glm::dvec2 position_m{0.0};  // between the wheels; at most 10⁶ m from the origin along an axis
  double heading_rad = 0.0;    // from east, counter-clockwise
  double speed_m_per_s = 0.0;  // −1…5, seen from above
  double turned_rad = 0.0;     // of the front wheels, to the left
  double rolled_m = 0.0;       // for the look of its wheels
};

inline constexpr double kMostCartSpeedMPerS = 5.0;
inline constexpr double kMostCartBackingMPerS = 1.0;
inline constexpr double kLongestCartStepS = 0.1;

/// The cart `dt_s` later, at most kLongestCartStepS; as it is where dt_s is not above zero. Uphill it gains
/// speed more slowly and downhill faster; without a pull it comes to rest, on any slope.
DrivenCart driven_on(DrivenCart cart, const CartControls& controls, double dt_s, const HeightField& ground);

MoverPlace place_of(const DrivenCart& cart, const HeightField& ground);

}  // namespace prairie
