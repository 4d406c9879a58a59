// How a walker moves: key frames of a recorded walk cycle, cubic Bézier curves between them, and an amplitude
// that follows the speed (G03 §5.3). Each curve passes through its key frames; its inner control points lie
// along the chord between the neighbours, a sixth of it away, so that it is once continuously differentiable
// and periodic.
//
// Deviation: the legs' angles are not key frames. The recorded cycle gives the soles (their pitch and their
// clearance), the pelvis, trunk and arms; hips and knees follow from where the feet stand
// (agents/walker_pose.h), so that feet do not slide.
//
// Stride and cadence: of walkers at freely chosen speeds both grow with the square root of the speed, their
// quotient staying the same (Sekiya and Nagasaki 1998, "Reproducibility of the walking patterns of normal
// young adults"), and walkers of another size move alike at the same Froude number (Alexander 1989). Very
// slow ones keep a cadence and shorten the stride.
#pragma once

#include <array>
#include <cstddef>

namespace prairie {

/// What a key frame holds. Angles in radians; lengths as shares of the leg, hip to ankle. Of the two sides it
/// is the left; the right does the same half a cycle later, mirrored.
enum class GaitCurve {
  kPelvisRise,  // hips over the ankle of a foot that stands flat
  kPelvisSway,  // to the left
  kPelvisYaw,   // of the line through the hips, counter-clockwise from above
  kPelvisList,  // of the same, left hip up
  kChestYaw,    // of the line through the shoulders
  kChestList,
  kChestPitch,  // of the trunk, forward
  kArmSwing,    // of the upper arm, forward
  kArmSpread,   // of the same, away from the body
  kElbow,       // flexion
  kSolePitch,   // toes up
  kSoleLift,    // of the sole's lowest point, over the ground
};
inline constexpr std::size_t kGaitCurveCount = 12;
inline constexpr std::size_t kGaitKeyCount = 16;

struct Gait {
  double speed_m_per_s = 0.0;  // as recorded, > 0
  double period_s = 0.0;       // of a stride, two steps
  double stance = 0.0;         // share of a stride in which a foot stands, 0.5…0.75
  double lead = 0.0;           // share of its stance that a foot is ahead of the hips as it strikes
  double half_width = 0.0;     // of the track, as a share of the leg
  /// At phases 0, 1/16, …; 0: the left heel strikes.
  std::array<std::array<double, kGaitKeyCount>, kGaitCurveCount> keys{};
};

/// The cycle that the program brings along, from CMU 02_01. "The data used in this project was obtained from
/// mocap.cs.cmu.edu. The database was created with funding from NSF EIA-0196217."
const Gait& recorded_gait();

/// A curve at a phase, of which only the part after the point counts.
double at_phase(const Gait& gait, GaitCurve curve, double phase);

/// `scale`: the walker's height over kFigureHeightM.
double stride_period_s(const Gait& gait, double speed_m_per_s, double scale);
double stance_share(const Gait& gait, double speed_m_per_s, double scale);
/// Of the key frames' departure from standing: 0 standing, 1 at the recorded speed, growing with the stride.
double gait_amplitude(const Gait& gait, double speed_m_per_s, double scale);

}  // namespace prairie
