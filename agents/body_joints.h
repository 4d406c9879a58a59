// Which joints of a recorded body are its hips, knees, ankles and so on: known by the names that CMU's
// conversions, MotionBuilder, Mixamo, 3ds Max Biped, Character Creator, VRM, Blender's Rigify and SMPL give
// them, in any case, with any prefix and any separators.
#pragma once

#include <array>
#include <cstddef>

#include "agents/bvh.h"

namespace prairie {

/// Of one side.
enum BodyPart { kHip, kKnee, kAnkle, kToes, kShoulder, kElbow, kWrist, kBodyPartCount };

/// The joints of a file that a gait is made from: left and right.
struct BodyJoints {
  std::array<std::array<std::size_t, kBodyPartCount>, 2> of_side{};
  std::size_t neck = 0;
};

/// Where a file names the ankle, "foot" is what hangs on it: its toes, as in SMPL. A foot without toes ends
/// in them. Throws BadInput that tells which joints are missing, which names were seen and which would do.
BodyJoints find_body_joints(const BvhMotion& motion);

}  // namespace prairie
