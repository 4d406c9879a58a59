// The walker's skeleton: joints, what hangs on what, and where they are at rest. The figure stands upright on
// level ground, arms hanging; X is its forward, Y its left, Z up, the origin on the ground between its feet.
// Segment lengths are those of Drillis and Contini 1966 as printed in Winter 2009, Biomechanics and Motor
// Control of Human Movement, fig. 4.1; places of the spine's and the feet's joints are our own. A walker of
// another height is the same figure scaled.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

namespace prairie {

enum class Joint {
  kPelvis,
  kSpine,
  kChest,
  kNeck,
  kHead,
  kLeftHip,
  kLeftKnee,
  kLeftAnkle,
  kLeftToes,
  kRightHip,
  kRightKnee,
  kRightAnkle,
  kRightToes,
  kLeftShoulder,
  kLeftElbow,
  kLeftWrist,
  kRightShoulder,
  kRightElbow,
  kRightWrist,
};
inline constexpr std::size_t kJointCount = 19;

constexpr std::size_t index_of(Joint joint) {
  return static_cast<std::size_t>(joint);
}
/// A joint of the left limbs, or its like of the right.
constexpr Joint on_side(Joint left, bool right) {
  const int step = left >= Joint::kLeftShoulder ? 3 : 4;
  return static_cast<Joint>(static_cast<int>(left) + (right ? step : 0));
}

struct RestJoint {
  Joint parent;  // its own for the pelvis
  glm::dvec3 place_m;
};

/// Height of the walker that the lengths below belong to.
inline constexpr double kFigureHeightM = 1.75;
inline constexpr double kThighM = 0.245 * kFigureHeightM;
inline constexpr double kShankM = 0.246 * kFigureHeightM;
inline constexpr double kLegM = kThighM + kShankM;  // hip to ankle
inline constexpr double kUpperArmM = 0.186 * kFigureHeightM;
inline constexpr double kForearmM = 0.146 * kFigureHeightM;
inline constexpr double kHalfHipsM = 0.09;  // between the hip joints' centres
inline constexpr double kHalfShouldersM = 0.175;
inline constexpr double kAnkleHeightM = 0.039 * kFigureHeightM;  // over the sole
inline constexpr double kToesHeightM = 0.023;
inline constexpr double kHeelBehindM = 0.055;  // of the ankle, where the sole rolls on as the foot strikes
inline constexpr double kBallAheadM = 0.125;   // of the ankle: the toes' joint
inline constexpr double kTipAheadM = 0.205;

/// By Joint.
inline constexpr std::array<RestJoint, kJointCount> kRestSkeleton = [] {
  constexpr double kHipZ = kAnkleHeightM + kLegM, kShoulderZ = 0.818 * kFigureHeightM;
  std::array<RestJoint, kJointCount> rest{};
  const auto set = [&rest](Joint joint, Joint parent, double x, double y, double z) {
    rest[index_of(joint)] = {parent, glm::dvec3(x, y, z)};
  };
  set(Joint::kPelvis, Joint::kPelvis, 0.0, 0.0, kHipZ);
  set(Joint::kSpine, Joint::kPelvis, -0.005, 0.0, kHipZ + 0.11);
  set(Joint::kChest, Joint::kSpine, -0.015, 0.0, kHipZ + 0.27);
  set(Joint::kNeck, Joint::kChest, -0.01, 0.0, 1.475);
  set(Joint::kHead, Joint::kNeck, 0.01, 0.0, 1.56);
  for (const bool right : {false, true}) {
    const auto of = [right](Joint left) { return on_side(left, right); };
    const double side = right ? -1.0 : 1.0;
    set(of(Joint::kLeftHip), Joint::kPelvis, 0.0, side * kHalfHipsM, kHipZ);
    set(of(Joint::kLeftKnee), of(Joint::kLeftHip), 0.0, side * kHalfHipsM, kAnkleHeightM + kShankM);
    set(of(Joint::kLeftAnkle), of(Joint::kLeftKnee), 0.0, side * kHalfHipsM, kAnkleHeightM);
    set(of(Joint::kLeftToes), of(Joint::kLeftAnkle), kBallAheadM, side * kHalfHipsM, kToesHeightM);
    set(of(Joint::kLeftShoulder), Joint::kChest, -0.015, side * kHalfShouldersM, kShoulderZ);
    set(of(Joint::kLeftElbow), of(Joint::kLeftShoulder), -0.015, side * kHalfShouldersM,
        kShoulderZ - kUpperArmM);
    set(of(Joint::kLeftWrist), of(Joint::kLeftElbow), -0.015, side * kHalfShouldersM,
        kShoulderZ - kUpperArmM - kForearmM);
  }
  return rest;
}();

}  // namespace prairie
