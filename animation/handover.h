// From the inertial back to the virtual model (B11 §3.4) without a jump. A blade whose own motion is spent
// follows its virtual blade again, and what it is off by at that moment fades.
#pragma once

#include "animation/chain_block.h"

namespace prairie {

/// Distance of the tips of two shapes, given by the turns of the same rest shape, as a share of the blade's
/// length.
float tip_gap(const ChainVectors& rest, const ChainVectors& turn, const ChainVectors& other);

/// Watches one inertial blade: its motion is spent when its tip has kept within `kNear` of the virtual one
/// for `kSteps` steps running.
struct SpentMotion {
  static constexpr float kNear = 0.03f;
  static constexpr int kSteps = 12;
  int near_steps = 0;

  /// To be called once in each step; whether the blade may return.
  bool watch(float gap) {
    near_steps = gap <= kNear ? near_steps + 1 : 0;
    return near_steps >= kSteps;
  }
};

/// What remains of an offset (turns less virtual turns) after a frame in which it moves the tip by no more
/// than `most_share` of the blade's length; zero in the end.
ChainVectors faded(const ChainVectors& offset, float most_share);

}  // namespace prairie
