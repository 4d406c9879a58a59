#include "agents/walker_pose.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "agents/sole.h"
#include "animation/heading.h"

namespace prairie {
namespace {

constexpr double kTurnsPerRad = 0.15915494309189535;
constexpr double kMostReach = 0.995;      // of a leg's length: knees never lock
constexpr double kStandingRise = 0.988;   // as GaitCurve::kPelvisRise, standing
constexpr double kStandingSpread = 0.08;  // of the arms, rad
constexpr double kClothes = 0.06;         // rad, by which they hold the arms away
constexpr double kStandingElbow = 0.18;
constexpr double kForearmInward = 0.45;                   // rad
constexpr double kHandHangs = 0.35;                       // of the elbow's flexion
constexpr double kToesOut = 0.10;                         // rad
constexpr double kLeanPerGrade = 0.45, kMostLean = 0.25;  // rad
constexpr double kLeanPerSpeed = 0.025;                   // rad per m/s
constexpr double kSwingEdge =
    0.15;  // of a swing's time, in which a sole leaves the ground or comes back to it
constexpr double kRestingLift = 0.45;   // of the recorded clearance, for steps on the spot
constexpr double kMostHeelRise = -1.2;  // rad, pitch of a foot that stands on its toes to reach
constexpr double kSoftM = 0.05;         // over which what is wanted gives way to what legs reach

/// Right-handed about axis 0, 1 or 2: forward, left, up.
glm::dmat3 turn_about(int axis, double rad) {
  const double turns = rad * kTurnsPerRad;
  const double s = sine_of_turns(turns), c = sine_of_turns(turns + 0.25);
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  glm::dmat3 matrix(1.0);
  matrix[next][next] = c;
  matrix[next][last] = s;
  matrix[last][next] = -s;
  matrix[last][last] = c;
  return matrix;
}
constexpr int kForward = 0, kLeft = 1, kUp = 2;

glm::dmat3 upright(glm::dvec2 forward) {
  return {glm::dvec3(forward, 0.0), glm::dvec3(-forward.y, forward.x, 0.0), glm::dvec3(0.0, 0.0, 1.0)};
}

glm::dmat3 axes_on(glm::dvec2 slope, glm::dvec2 forward) {
  const glm::dvec3 up = glm::normalize(glm::dvec3(-slope, 1.0));
  const glm::dvec3 ahead = glm::normalize(glm::dvec3(forward, glm::dot(slope, forward)));
  return {ahead, glm::cross(up, ahead), up};
}

double smooth_ramp(double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

/// At most the lesser of both, from which it departs only where they are nearly equal; once continuously
/// differentiable.
double soft_min(double a, double b, double width) {
  const double near = std::max(width - std::abs(a - b), 0.0);
  return std::min(a, b) - near * near / (4.0 * width);
}

glm::dvec3 rest_offset(Joint joint) {
  const RestJoint& rest = kRestSkeleton[index_of(joint)];
  return rest.place_m - kRestSkeleton[index_of(rest.parent)].place_m;
}

/// A walker between its parameters and its pose.
class Posing {
 public:
  Posing(const Gait& gait, const Footing& footing, glm::dvec2 position_m, glm::dvec2 forward,
         const HeightField& ground)
      : gait_(gait),
        footing_(footing),
        ground_(ground),
        position_m_(position_m),
        forward_(forward),
        scale_(footing.scale),
        amplitude_(gait_amplitude(gait, footing.speed_m_per_s, footing.scale)) {}

  WalkerPose pose() {
    raise_pelvis();
    for (const bool right : {false, true}) place_foot(right);
    lower_pelvis();
    for (const bool right : {false, true}) place_leg(right);
    place_trunk();
    for (const bool right : {false, true}) place_arm(right);
    return pose_;
  }

 private:
  JointFrame& at(Joint joint) { return pose_[index_of(joint)]; }
  double curve(GaitCurve of, double phase) const { return at_phase(gait_, of, phase); }
  /// Standing as it should be standing, walking as recorded.
  double blended(double standing, double recorded) const {
    return standing + amplitude_ * (recorded - standing);
  }

  void attach(Joint joint, const glm::dmat3& axes) {
    const JointFrame& parent = at(kRestSkeleton[index_of(joint)].parent);
    at(joint) = {parent.place_m + scale_ * (parent.axes * rest_offset(joint)), axes};
  }

  void place_foot(bool right) {
    const Foot& foot = footing_.feet[right ? 1 : 0];
    const double phase = key_phase(gait_, foot);
    double pitch = amplitude_ * curve(GaitCurve::kSolePitch, phase);
    double lift_m = 0.0, follow = 0.0;
    if (!foot.planted) {
      const double off_ground =
          smooth_ramp(foot.share / kSwingEdge) * smooth_ramp((1.0 - foot.share) / kSwingEdge);
      const double recorded_m = kLegM * std::max(curve(GaitCurve::kSoleLift, phase), 0.0);
      lift_m = off_ground * (kRestingLift + (1.0 - kRestingLift) * amplitude_) * recorded_m;
      follow = smooth_ramp(foot.share / 0.4);
    }
    const glm::dmat3 turned_out = turn_about(kUp, right ? -kToesOut : kToesOut);
    const glm::dmat3 on_ground = axes_on(glm::dvec2(ground_.slope(foot.position_m)),
                                         glm::dvec2(upright(foot.forward) * turned_out[0]));
    const glm::dvec3 below_m(foot.position_m, static_cast<double>(ground_.height_m(foot.position_m)));
    const glm::dvec3 hip_m = hip_of(right) - below_m;
    const glm::dvec2 hip_aside_m(glm::dot(hip_m, on_ground[0]),
                                 glm::dot(hip_m, on_ground[2]) - scale_ * lift_m);
    const double stretched = reaching_pitch(hip_aside_m, pitch);
    pitch += (1.0 - follow) * (stretched - pitch);
    const glm::dvec2 ankle_m = rolled_ankle(pitch);
    const Joint ankle = on_side(Joint::kLeftAnkle, right), toes = on_side(Joint::kLeftToes, right);
    at(ankle) = {below_m + scale_ * (on_ground * glm::dvec3(ankle_m.x, 0.0, ankle_m.y + lift_m)),
                 on_ground * turn_about(kLeft, -pitch)};
    // Toes lie on the ground while the heel rises, and go with the foot once it has left the ground.
    const double toes_pitch = pitch > 0.0 ? pitch : follow * pitch;
    attach(toes, on_ground * turn_about(kLeft, -toes_pitch));
  }

  glm::dvec3 hip_of(bool right) {
    const JointFrame& pelvis = at(Joint::kPelvis);
    return pelvis.place_m + scale_ * (pelvis.axes * rest_offset(on_side(Joint::kLeftHip, right)));
  }

  /// The pitch of a foot whose heel rises for the leg to reach it, seen from the side; as given where it
  /// does.
  double reaching_pitch(glm::dvec2 hip_m, double pitch) const {
    const auto leg_m = [&](double with_pitch) {
      return glm::length(hip_m / scale_ - rolled_ankle(with_pitch));
    };
    const double flat_m = leg_m(pitch), behind_m = hip_m.x / scale_;
    // A foot just below the hip stays flat.
    const double soft_m = std::clamp(0.2 * behind_m, 1e-4, kSoftM);
    const double reach_m = soft_min(flat_m, kMostReach * kLegM, soft_m);
    if (behind_m < 0.0 || reach_m == flat_m) return pitch;
    const auto reaches = [&](double with_pitch) { return leg_m(with_pitch) <= reach_m; };
    double enough = std::min(kMostHeelRise, pitch), too_little = pitch;
    if (!reaches(enough)) return enough;
    for (int halving = 0; halving < 14; ++halving) {
      const double middle = 0.5 * (enough + too_little);
      (reaches(middle) ? enough : too_little) = middle;
    }
    return enough;
  }

  /// As high as the gait wants it.
  void raise_pelvis() {
    const double phase = footing_.phase;
    const glm::dmat3 heading = upright(forward_);
    const double yaw = amplitude_ * curve(GaitCurve::kPelvisYaw, phase);
    const double list = amplitude_ * curve(GaitCurve::kPelvisList, phase);
    const glm::dmat3 axes = heading * turn_about(kUp, yaw) * turn_about(kForward, list);
    const double sway_m = amplitude_ * kLegM * curve(GaitCurve::kPelvisSway, phase);
    const double rise = blended(kStandingRise, curve(GaitCurve::kPelvisRise, phase));
    glm::dvec3 place_m(position_m_, static_cast<double>(ground_.height_m(position_m_)));
    place_m += scale_ * (sway_m * heading[1] + (kAnkleHeightM + kLegM * rise) * heading[2]);
    at(Joint::kPelvis) = {place_m, axes};
  }

  /// To where both legs reach.
  void lower_pelvis() {
    glm::dvec3& place_m = at(Joint::kPelvis).place_m;
    const double reach_m = kMostReach * kLegM * scale_;
    const double soft_m = kSoftM * scale_ * (0.1 + 0.9 * std::min(amplitude_, 1.0));
    for (const bool right : {false, true}) {
      const glm::dvec3 hip_m = hip_of(right);
      const glm::dvec3 ankle_m = at(on_side(Joint::kLeftAnkle, right)).place_m;
      const glm::dvec2 aside_m = glm::dvec2(hip_m) - glm::dvec2(ankle_m);
      const double height_m =
          std::sqrt(std::max(reach_m * reach_m - glm::dot(aside_m, aside_m), 0.1 * reach_m * reach_m));
      place_m.z = soft_min(place_m.z, ankle_m.z + height_m - (hip_m.z - place_m.z), soft_m);
    }
  }

  /// Hip, knee and ankle in the plane of the leg and of where the knee points, which is half with the foot.
  void place_leg(bool right) {
    const Joint hip = on_side(Joint::kLeftHip, right), knee = on_side(Joint::kLeftKnee, right);
    const Foot& foot = footing_.feet[right ? 1 : 0];
    attach(hip, glm::dmat3(1.0));
    JointFrame& ankle = at(on_side(Joint::kLeftAnkle, right));
    const double thigh_m = scale_ * kThighM, shank_m = scale_ * kShankM;
    const glm::dvec3 hip_m = at(hip).place_m;
    const glm::dvec3 leg_m = hip_m - ankle.place_m;
    const double length_m = glm::length(leg_m);
    // A body that outruns its feet pulls them along.
    const double reach_m = std::clamp(length_m, 0.2 * (thigh_m + shank_m), 0.9999 * (thigh_m + shank_m));
    const glm::dvec3 up = leg_m / std::max(length_m, 1e-9);
    if (reach_m != length_m) {
      const glm::dvec3 moved_m = hip_m - reach_m * up - ankle.place_m;
      ankle.place_m += moved_m;
      at(on_side(Joint::kLeftToes, right)).place_m += moved_m;
    }
    const glm::dvec3 ahead(forward_ + foot.forward, 0.0);
    const glm::dvec3 across = ahead - glm::dot(ahead, up) * up;
    const glm::dvec3 pole = across / std::max(glm::length(across), 1e-9);
    const double along_m = (reach_m * reach_m + thigh_m * thigh_m - shank_m * shank_m) / (2.0 * reach_m);
    const double bend_m = std::sqrt(std::max(thigh_m * thigh_m - along_m * along_m, 0.0));
    const glm::dvec3 knee_m = hip_m - along_m * up + bend_m * pole;
    const glm::dvec3 hinge = glm::cross(up, pole);
    const auto bone_axes = [hinge](glm::dvec3 top_m, glm::dvec3 bottom_m) {
      const glm::dvec3 bone = glm::normalize(top_m - bottom_m);
      return glm::dmat3(glm::cross(hinge, bone), hinge, bone);
    };
    at(hip).axes = bone_axes(hip_m, knee_m);
    at(knee) = {knee_m, bone_axes(knee_m, ankle.place_m)};
  }

  void place_trunk() {
    const double phase = footing_.phase;
    const double grade = glm::dot(glm::dvec2(ground_.slope(position_m_)), forward_);
    const double lean = std::clamp(kLeanPerGrade * grade, -kMostLean, kMostLean) +
                        kLeanPerSpeed * footing_.speed_m_per_s +
                        amplitude_ * curve(GaitCurve::kChestPitch, phase);
    const double yaw = amplitude_ * curve(GaitCurve::kChestYaw, phase);
    const double list = amplitude_ * curve(GaitCurve::kChestList, phase);
    const double pelvis_yaw = amplitude_ * curve(GaitCurve::kPelvisYaw, phase);
    const double pelvis_list = amplitude_ * curve(GaitCurve::kPelvisList, phase);
    const glm::dmat3 heading = upright(forward_);
    const auto trunk = [&](double turned, double leaned, double listed) {
      return heading * turn_about(kUp, turned) * turn_about(kLeft, leaned) * turn_about(kForward, listed);
    };
    attach(Joint::kSpine, trunk(0.5 * (yaw + pelvis_yaw), 0.6 * lean, 0.5 * (list + pelvis_list)));
    attach(Joint::kChest, trunk(yaw, lean, list));
    attach(Joint::kNeck, trunk(0.5 * yaw, 0.6 * lean, 0.5 * list));
    attach(Joint::kHead, trunk(0.0, 0.25 * lean, 0.0));
  }

  void place_arm(bool right) {
    const double phase = footing_.phase + (right ? 0.5 : 0.0), out = right ? -1.0 : 1.0;
    const double swing = amplitude_ * curve(GaitCurve::kArmSwing, phase);
    const double spread = kClothes + blended(kStandingSpread, curve(GaitCurve::kArmSpread, phase));
    const double elbow = std::max(blended(kStandingElbow, curve(GaitCurve::kElbow, phase)), 0.05);
    const glm::dmat3 upper =
        upright(forward_) * turn_about(kForward, out * spread) * turn_about(kLeft, -swing);
    const glm::dmat3 lower = upper * turn_about(kUp, -out * kForearmInward) * turn_about(kLeft, -elbow);
    attach(on_side(Joint::kLeftShoulder, right), upper);
    attach(on_side(Joint::kLeftElbow, right), lower);
    attach(on_side(Joint::kLeftWrist, right), lower * turn_about(kLeft, kHandHangs * elbow));
  }

  const Gait& gait_;
  const Footing& footing_;
  const HeightField& ground_;
  glm::dvec2 position_m_, forward_;
  double scale_, amplitude_;
  WalkerPose pose_;
};

}  // namespace

WalkerPose pose_of(const Gait& gait, const Footing& footing, glm::dvec2 position_m, glm::dvec2 forward,
                   const HeightField& ground) {
  return Posing(gait, footing, position_m, forward, ground).pose();
}

}  // namespace prairie
