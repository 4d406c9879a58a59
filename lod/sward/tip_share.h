// How far wind moves the tips of a species' blades, which lean and curve and differ, by how far it moves the
// tip of its virtual blade (animation/virtual_blades.h): what strips, which stand for many blades, lean by.
#pragma once

#include "shaders/shared/layouts.h"

namespace prairie {

/// Tips move by (still + bent · t) t where the virtual one moves by t, as shares of lengths.
struct TipShare {
  float still = 1.0f;
  float bent = 0.0f;
};

/// Means over the species' blades and all directions of the wind.
TipShare tip_share(const SpeciesParams& species);

}  // namespace prairie
