// The simulated state of a walker's feet: where each stands or, on its way, is; each treads on its own (G03
// §5.4). Plain data of which all of the pose follows (agents/walker_pose.h). A foot that stands does not move
// until it lifts. One that swings goes to where the body, at its speed, will be a part of a stance after it
// strikes. Standing walkers step only to bring their feet back below them: after a stop, and as they turn on
// the spot.
//
// Only + − × ÷ √ and floor, so that it is the same everywhere.
#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "agents/gait.h"

namespace prairie {

struct Foot {
  glm::dvec2 position_m{0.0};    // on the ground, below the ankle of the foot when it is flat
  glm::dvec2 forward{1.0, 0.0};  // unit
  bool planted = true;
  double share = 0.0;       // done of its stance or of its swing, 0…1
  double lift_phase = 0.0;  // its own phase as it lifted
  bool operator==(const Foot&) const = default;
};

struct Footing {
  double scale = 1.0;          // the walker's height over kFigureHeightM
  double phase = 0.0;          // of the gait, 0…1; 0: the left heel strikes, 1/2: the right one
  double speed_m_per_s = 0.0;  // the body's, steadied: how far the gait departs from standing
  std::array<Foot, 2> feet;    // left, right
  bool operator==(const Footing&) const = default;
};

/// Throws BadInput, the field in it, where a footing that came from elsewhere cannot be one.
void check(const Footing& footing);

/// Both feet side by side. `forward`: a unit vector; `scale`: 0.3…3.
Footing standing(glm::dvec2 position_m, glm::dvec2 forward, double scale);

/// Where the body is after a step.
struct BodyStep {
  glm::dvec2 position_m{0.0};
  glm::dvec2 forward{1.0, 0.0};  // unit; the walker moves and looks there
  double speed_m_per_s = 0.0;    // ≥ 0
  double grade = 0.0;            // rise of the ground along forward, per metre: on slopes steps are shorter
};

/// Moves the feet on by `dt_s`, 0…0.1, after which the body is there. A body that is suddenly more than two
/// legs away from its feet stands there anew.
void advance(Footing& footing, const Gait& gait, const BodyStep& body, double dt_s);

/// Place of a foot in the cycle of the gait's key frames, in which it stands for `gait.stance`.
double key_phase(const Gait& gait, const Foot& foot);

}  // namespace prairie
