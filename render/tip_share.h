// How far wind moves the tips of a species' blades, which lean and curve and differ, by how far it moves the tip of its virtual
// blade (animation/virtual_blades.h): what strips, which stand for many blades, lean by.
#pragma once

#include "shaders/shared/layouts.h"

namespace prairie {

/// Mean over the species' blades and all directions of the wind, of displacements along it as shares of lengths.
float tip_share(const SpeciesParams& species);

}  // namespace prairie
