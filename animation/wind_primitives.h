// Winds of limited extent that move over the ground (G03 §4.1): each adds its velocity where its mask covers
// the ground. All are pure functions of place and time, and 0 at the border of their mask, with continuous
// slopes.
//
// Headings: radians from east, counter-clockwise, towards which something blows or moves.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <variant>

namespace prairie {

/// A front that travels over the ground, rises fast and dies down slowly behind.
struct Gust {
  glm::dvec2 origin_m{0.0};  // of the middle of the front at `start_s`
  double heading_rad = 0.0;
  double travel_m_per_s = 8.0;    // of the front, above 0
  double strength_m_per_s = 6.0;  // of its wind
  double width_m = 60.0;          // of the front
  double depth_m = 30.0;          // from the front to the calm behind it
  double way_m = 300.0;           // after which it has died down
  double start_s = 0.0;
};

/// A vortex that wanders about a straight way. Speed across the radius: s · 2q/(1 + q²), q = r/radius
/// (Kaufmann's vortex), down to 0 at `reach_m`; turns counter-clockwise, clockwise if `strength` is negative.
struct Tornado {
  glm::dvec2 origin_m{0.0};  // about where its eye is at `start_s`
  double heading_rad = 0.0;
  double travel_m_per_s = 2.0;
  double strength_m_per_s = 15.0;  // at `radius_m`
  double radius_m = 3.0;
  double reach_m = 25.0;  // at least the radius
  double inflow = 0.3;    // speed towards the eye by speed around it
  double wander_m = 4.0;  // how far it leaves its way
  double wander_s = 9.0;  // about how long it is away
  double start_s = 0.0;
  double duration_s = 60.0;
  std::uint32_t seed = 1;  // of its wandering
};

/// Soft waves that run over the ground.
struct Breeze {
  glm::dvec2 origin_m{0.0};  // of its disc
  double heading_rad = 0.0;
  double strength_m_per_s = 1.5;  // between 0 and this
  double period_s = 4.0;
  double wavelength_m = 18.0;
  double radius_m = 0.0;  // of the disc that it covers; 0: everywhere
};

using WindPrimitive = std::variant<Gust, Tornado, Breeze>;

/// Throws BadInput, `name` and the field in it, on a number that is not finite or out of range.
void check(const WindPrimitive& primitive, const std::string& name);

/// A primitive at one time: what is the same for all places.
struct BlowingPrimitive {
  const WindPrimitive* primitive;  // has to outlive this
  double time_s;
  glm::dvec2 forward;        // unit vector of the heading
  glm::dvec2 centre_m;       // of a gust's front, a tornado's eye, a breeze's disc
  float strength;            // by age, 0…1
  glm::dvec2 low_m, high_m;  // box of the ground outside which it does nothing; ±1e300 if there is none
};

/// Nothing if it does nothing anywhere at that time.
std::optional<BlowingPrimitive> blowing(const WindPrimitive& primitive, double time_s);

/// Velocity that it adds, m/s.
glm::vec2 velocity_m_per_s(const BlowingPrimitive& blowing, glm::dvec2 position_m);
glm::vec2 velocity_m_per_s(const WindPrimitive& primitive, glm::dvec2 position_m, double time_s);

/// From then on it does nothing; infinite for a breeze.
double end_s(const WindPrimitive& primitive);

}  // namespace prairie
