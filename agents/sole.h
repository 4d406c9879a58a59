// How a foot rolls over its sole without sliding: on the heel as it strikes, flat, then on the toes' joint,
// the toes lying flat. In the foot's own plane, X forward and Z up, the origin on the ground below the ankle
// of the foot when it is flat.
#pragma once

#include <glm/vec2.hpp>

#include "agents/skeleton.h"
#include "animation/heading.h"

namespace prairie {

/// Where the ankle is, metres for a walker of kFigureHeightM; `pitch_rad`: toes up. Continuous.
inline glm::dvec2 rolled_ankle(double pitch_rad) {
  const glm::dvec2 pivot =
      pitch_rad > 0.0 ? glm::dvec2(-kHeelBehindM, 0.0) : glm::dvec2(kBallAheadM, kToesHeightM);
  const glm::dvec2 from_pivot = glm::dvec2(0.0, kAnkleHeightM) - pivot;
  const double turns = pitch_rad * 0.15915494309189535;
  const double s = sine_of_turns(turns), c = sine_of_turns(turns + 0.25);
  return pivot + glm::dvec2(c * from_pivot.x - s * from_pivot.y, s * from_pivot.x + c * from_pivot.y);
}

}  // namespace prairie
