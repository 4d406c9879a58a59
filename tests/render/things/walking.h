// A walker in the middle of a walk, as it is drawn.
#pragma once

#include "animation/heading.h"
#include "render/things/walker_look.h"

namespace prairie {

/// One that has come straight to a place in so many seconds, from a stand; `heading_rad` from east,
/// counter-clockwise.
inline WalkerLook walking(const HeightField& ground, glm::dvec2 to_m, double heading_rad,
                          double speed_m_per_s, double seconds, double height_m = 1.75,
                          std::uint32_t seed = 1) {
  constexpr double kStepS = 1.0 / 60.0;
  BodyStep body;
  body.forward = direction_of(heading_rad);
  body.speed_m_per_s = speed_m_per_s;
  body.position_m = to_m - seconds * speed_m_per_s * body.forward;
  Footing footing = standing(body.position_m, body.forward, height_m / kFigureHeightM);
  for (double t = 0.0; t < seconds - 1e-9; t += kStepS) {
    body.position_m += speed_m_per_s * kStepS * body.forward;
    advance(footing, recorded_gait(), body, kStepS);
  }
  return {height_m, seed, pose_of(recorded_gait(), footing, body.position_m, body.forward, ground)};
}

}  // namespace prairie
