// The gait of a recorded walk (G03 §5.3 takes its key frames from "cyclic motion data of a human character
// walking"). Heel strikes are where the ankle is farthest ahead of the hips, toe-offs a little before the
// toes are farthest behind (Zeni, Richards and Higginson 2008, "Two simple methods for determining gait
// events"). Every whole cycle of either foot, the right one's mirrored, is resampled at the key frames'
// phases; their mean is the gait, which so is symmetric.
//
// Only where joints are is used, never their rotations: files differ in their poses at rest.
#pragma once

#include <optional>

#include "agents/bvh.h"
#include "agents/gait.h"

namespace prairie {

/// `unit_m`: metres of one unit of the file's lengths; nothing: such that its leg, hip to ankle, is as long
/// as the figure's (agents/skeleton.h). Any axis may be up, the way straight, curved or on the spot
/// (agents/measured_walk.h), joints have one of many names (agents/body_joints.h). Throws BadInput that names
/// the joints that are missing, or where the motion is no walk of at least one whole stride.
Gait gait_of(const BvhMotion& motion, std::optional<double> unit_m = std::nullopt);

}  // namespace prairie
