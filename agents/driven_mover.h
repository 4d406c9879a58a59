// A mover whose place is set from outside, step by step, such as one that a person drives.
#pragma once

#include "agents/mover.h"

namespace prairie {

/// Plain data. Who sets `place` leaves `before` alone, unless the thing is put down somewhere else: then both
/// are that place.
struct DrivenMover {
  MoverKind kind = MoverKind::kStone;
  double radius_m = 0.4;  // of the stone; half the width of the cart; 0.05…3
  MoverPlace place;
  MoverPlace before;      // at the end of the last step; at most 100 m away
  double rolled_m = 0.0;  // for the look of its wheels
};

}  // namespace prairie
