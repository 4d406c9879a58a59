// Blades that an object touches (B11 §2.1, §3.4): their segments are bent so that none is inside it, and
// their velocities are zero; afterwards they swing inertially. It is the drawn curve that is kept outside, to
// a millimetre, not only the chain's rods.
#pragma once

#include "animation/inertial_chains.h"
#include "animation/solids.h"

namespace prairie {

/// Bends a blade out of a solid; both in the same frame, in metres. `rest`, `growth`: as for
/// Kernels::turned_chain_over, with which the blade is drawn; `up`: the ground's normal at its root, below
/// which no segment is pressed. A blade whose root is inside the solid, or nearer to it than can be seen,
/// lies on the ground. Returns whether the blade was touched; if so, `motion` is without velocity.
bool bend_out(const Solid& solid, const Blade& blade, const Kernels::BladeCurve& rest, float growth,
              glm::vec3 up, ChainMotion& motion, float least_rise = -1.0f);

}  // namespace prairie
