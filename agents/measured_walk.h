// A recorded walk in metres on a straight way, whichever way up the file is, and wherever it was walked:
// along a line, in curves, or on the spot.
//
// Up is where the neck is over the ankles. A way that is nearly straight is taken as it is. Else each frame
// is turned by the body's own heading, at right angles to its hips and averaged over a stride, and set down
// as far along a line as the hips have gone that way; on the spot (a treadmill, "in place" of animation
// libraries), as far as the standing feet have gone backwards under them.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "agents/body_joints.h"
#include "agents/bvh.h"

namespace prairie {

/// In metres: X along the way, Y to its left, Z up.
struct WalkFrame {
  std::array<std::array<glm::dvec3, kBodyPartCount>, 2> places_m;
  glm::dvec3 neck_m;
  glm::dvec3 hips_m() const { return 0.5 * (places_m[0][kHip] + places_m[1][kHip]); }
};

/// All a gait is measured from.
struct Walk {
  std::string file;
  double frame_s = 0.0;
  double leg_m = 0.0;
  double ankle_m = 0.0;              // height of an ankle whose foot stands flat
  std::array<double, 2> flat_rad{};  // pitch of ankle to toes there
  std::vector<WalkFrame> frames;
};

/// `unit_m`: metres of one unit of the file's lengths; nothing: such that its leg is as long as the figure's.
/// Throws BadInput where nobody stands or walks.
Walk measured_walk(const BvhMotion& motion, const BodyJoints& joints, std::optional<double> unit_m);

/// What is wrong with a motion, and what would do.
[[noreturn]] void refuse_motion(const BvhMotion& motion, const std::string& found);

double value_at_share(std::vector<double> values, double share);

/// Of a bone against the horizon, radians.
double pitch_of(glm::dvec3 bone);

}  // namespace prairie
