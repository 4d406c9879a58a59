// The pose of a walker: a pure function of its gait, its feet and where its body is (G03 §5.3). Pelvis, trunk
// and arms follow the key curves; the legs reach the feet by the law of cosines, knees forward; a foot rolls
// over heel and toes on the ground's slope below it (agents/sole.h). The pelvis sinks where a leg would not
// reach, as on steep ground.
//
// Deviation: G03 adapts the whole skeleton's amplitude only; here what touches the ground is placed first.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "agents/footing.h"
#include "agents/gait.h"
#include "agents/skeleton.h"
#include "maps/height_field.h"

namespace prairie {

/// A joint and the bone it carries: a point p of the resting figure (agents/skeleton.h), scaled, is now at
/// place_m + axes · (p − rest place), scaled alike.
struct JointFrame {
  glm::dvec3 place_m{0.0};
  glm::dmat3 axes{1.0};  // unit columns forward, left, up of the bone
};

using WalkerPose = std::array<JointFrame, kJointCount>;  // by Joint

/// `forward`: unit, where the body heads. Continuous in time if its arguments are.
WalkerPose pose_of(const Gait& gait, const Footing& footing, glm::dvec2 position_m, glm::dvec2 forward,
                   const HeightField& ground);

}  // namespace prairie
